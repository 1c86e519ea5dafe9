mkdir underlay overlay
echo 'echo from the underlay' > underlay/drive
echo 'echo from the overlay' > overlay/drive
chmod u+x underlay/drive overlay/drive
PATH=$PWD/underlay:$PATH
PATH=$PWD/overlay:$PATH
drive
