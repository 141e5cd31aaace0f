def sleep_us(microseconds):
    pass
