def main():
    print('Hi from the_simplest_python_package.')


if __name__ == '__main__':
    main()
