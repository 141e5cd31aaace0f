import board_world as world


def pitch(frequency, duration=-1, pin=0, wait=True):
    if not isinstance(frequency, int) or not isinstance(duration, int):
        raise TypeError("can't convert float to int")
    world.log("pitch", frequency, duration)
    if wait:
        world.advance(duration)


def stop():
    world.log("music stop")
