# What the sensors of the robot measure at a time in milliseconds.


def touched(is_left, time):
    first = 1500 if is_left else 2700
    return first <= time % 4000 < first + 300


def reflection(time):
    return 20 if time % 2600 >= 1300 else 60


def distance(time):
    return 150 if time % 5000 >= 3000 else 900


def colour(time):
    return ("WHITE", "RED", "BLACK", "YELLOW", "BLUE", "GREEN")[time // 700 % 6]


def loudness(time):
    return 80 if time % 3000 >= 2000 else 10


def pressed(name, time):
    first = {"LEFT": 600, "RIGHT": 1200, "CENTER": 1800}.get(name, 9000)
    return first <= time % 3000 < first + 400
