//// DIVIDE

def divide(a, b):
    # Whole numbers are divided towards zero, as in Robolang.
    quotient = abs(a) // abs(b)
    return quotient if (a < 0) == (b < 0) else -quotient

//// REMAINDER

def remainder(a, b):
    return a - b * divide(a, b)

//// DECIMAL_REMAINDER

def decimal_remainder(a, b):
    return a - b * int(a / b)

//// RANDOM

def random(a, b):
    # From the smaller to the larger number.
    return randint(min(a, b), max(a, b))

//// COUNT

def count(first, last, step):
    # The numbers from first to last, both included.
    return range(first, last + (1 if step > 0 else -1), step)

//// PEN_DOWN

@ASYNC@def pen_down():
    @AWAIT@pen_motor.run_target(300, 90)

//// PEN_UP

@ASYNC@def pen_up():
    @AWAIT@pen_motor.run_target(300, 0)

//// SET_POWER

def set_power(power):
    # Each step of power is 120 degrees of a wheel a second. The hub refuses 0, and what its motors cannot do.
    global speed, turn_rate
    power = max(power, 1 / 3)
    speed = @SPEED@
    turn_rate = @RATE@
    robot.settings(straight_speed=speed, turn_rate=turn_rate)
@DRIVE_ON@

//// RUN_ON

def run_on(motor, speed):
    # A motor that turns goes on with its new speed.
    if speed != 0 and not motor.done():
        motor.run(speed)

//// SHOW

def show(number):
    print(number)
    hub.display.number(number)

//// SHOW, screen

def show(number):
    print(number)
    hub.screen.print(number)

//// BLINK

@ASYNC@def blink(time):
    # This hub has no speaker.
    hub.light.on(Color.WHITE)
    @AWAIT@wait(time)
    hub.light.off()

//// DISTANCE

@ASYNC@def distance():
    # In whole centimetres; 255 if there is nothing.
    mm = @AWAIT@sonar.distance()
    return 255 if mm >= 2000 else mm // 10

//// MY_TURN

async def my_turn():
    # The main program waits while a behaviour acts.
    while acting > 0:
        await wait(10)

//// WHENEVER

async def whenever(number, condition, action):
    # Acts once each time the condition becomes true. A higher number goes first.
    global acting
    while True:
        while not await condition() or acting > number:
            await wait(10)
        acting = number
        await action()
        while acting == number and await condition():
            await wait(10)
        if acting == number:
            acting = 0
