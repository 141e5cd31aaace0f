import board_world as world


def time_pulse_us(pin, level, timeout=1000000):
    centimetres = world.distance()
    return -1 if centimetres == 255 else centimetres * 58
