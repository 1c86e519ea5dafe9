cat > drive.py << END
def main():
    print("driving")
    return 3


if __name__ == "__main__":
    main()
END
python3 drive.py
echo $?
python3 -c 'import sys, drive; sys.exit(drive.main())'
echo $?
