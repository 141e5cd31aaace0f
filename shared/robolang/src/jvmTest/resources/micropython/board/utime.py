# What a chip or a sensor needs between two signals takes no time here, as the signals themselves.


def sleep_us(microseconds):
    pass
