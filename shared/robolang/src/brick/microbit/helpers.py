//// FAIL

def fail(line, what):
    # Ends the program with the line in Robolang.
    stop()
    text = "@LINE@ %d: %s" % (line, what)
    print(text)
    display.scroll(text)
    raise SystemExit

//// WRAP

def wrap(x):
    # Whole numbers have 32 bits in Robolang.
    return (x + 2147483648) % 4294967296 - 2147483648

//// DIVIDE

def divide(a, b, line):
    # Whole numbers are divided towards zero, as in Robolang.
    if b == 0:
        fail(line, "%d / 0" % a)
    quotient = abs(a) // abs(b)
    return quotient if (a < 0) == (b < 0) else -quotient

//// REMAINDER

def remainder(a, b, line):
    return a - b * divide(a, b, line)

//// QUOTIENT

def quotient(a, b):
    # A decimal number divided by 0 is infinite, as in Robolang.
    return a / b if b else a * float("inf")

//// DECIMAL_REMAINDER

def decimal_remainder(a, b):
    return a - b * int(a / b) if b else a

//// ROOT

def root(x, line):
    if x < 0:
        fail(line, "sqrt(%s)" % x)
    return sqrt(x)

//// POWER_OF

def power_of(a, b, line):
    if a < 0 and b != int(b):
        fail(line, "pow(%s, %s)" % (a, b))
    return float(a) ** b if a or b >= 0 else float("inf")

//// RANDOM

def random(a, b):
    # From the smaller to the larger number.
    return randint(min(a, b), max(a, b))

//// ITEM

def item(values, place, line):
    if place < 0 or place >= len(values):
        fail(line, "[%d]" % place)
    return values[place]

//// PUT

def put(values, place, value, line):
    item(values, place, line)
    values[place] = value

//// TIMES

def times(n, line):
    if n < 0:
        fail(line, "repeat %d" % n)
    return range(n)

//// STEP

def step(x, line):
    if x == 0:
        fail(line, "step 0")
    return x

//// COUNT

def count(first, last, by, line):
    # The numbers from first to last, both included.
    return range(first, last + (1 if step(by, line) > 0 else -1), by)

//// MILLISECONDS

def milliseconds(time, line):
    if time < 0:
        fail(line, "wait %s ms" % time)
    return int(time + 0.5)

//// POWER

def power(x, line):
    if x < 0 or x > 7:
        fail(line, "power %d" % x)
    return x

//// STOP

def stop():
    wheels(0, 0)@QUIET@

//// START

def start():
    # The buggy itself keeps what its wheels do: they are stopped first.
@BEGIN@
    display.show(Image.ARROW_W)
    while not button_a.was_pressed():
        sleep(10)@RELEASE@
    display.clear()

//// START, I2C

def start():
    # The buggy itself keeps what its wheels do: they are stopped first.
    try:
@BEGIN@
    except OSError:
        print("@BUGGY@")
        display.scroll("@BUGGY@")
        raise SystemExit
    display.show(Image.ARROW_W)
    while not button_a.was_pressed():
        sleep(10)@RELEASE@
    display.clear()

//// BYTE

def byte(percent):
    return (max(0, percent) * 255 + 50) // 100

//// PULSE

def pulse(percent):
    # A pulse of 1.5 ms is the middle, but 0 stops a motor for sure.
    return ((1500 + 5 * percent) * 1023 + 10000) // 20000 if percent else 0

//// BRIDGE

def bridge(ahead, back, percent):
    # The pin that is low comes first.
    pins = (back, ahead) if percent >= 0 else (ahead, back)
    pins[0].write_analog(0)
    pins[1].write_analog((abs(percent) * 1023 + 50) // 100)

//// WHEELS

def wheels(left, right):
    # Each is 1 for ahead, -1 for back, 0 to stop.
    left *= LEFT
    right *= RIGHT
@FRAMES@

//// WHEELS, powers

def wheels(left, right):
    # Each is 1 for ahead, -1 for back, 0 to stop.
    global left_way, right_way
    left_way = left
    right_way = right
    left *= @LEFT@
    right *= @RIGHT@
@FRAMES@

//// SET_POWER

def set_power(left, right):
    global left_power, right_power
    left_power = left
    right_power = right
    if left_way or right_way:
        wheels(left_way, right_way)

//// SERVO

def servo(degrees):
@SERVO@

//// READY

def ready(above):
    # The number of the last behaviour above whose condition is true, or 0.@GUARD@
    k = len(behaviours)
    while k > above and not behaviours[k - 1][0]():
        k -= 1@UNGUARD@
    return k if k > above else 0

//// LOOK

class Over(Exception):
    # A later behaviour takes over.
    pass


def look():
    # Lets the behaviour act whose condition is true, and those that take over. The program goes on with True then.
    global acting@DRIVING@
    k = ready(acting)
    if k == 0:
        return False
@CUT@
    if acting:
        raise Over(k)
    while k:
        acting = k
        try:
            behaviours[k - 1][1]()
            # While its condition stays true, it is not done.
            while ready(0) == k:
                sleep(1)
            k = ready(0)
        except Over as over:
            k = over.args[0]
    acting = 0
    return True

//// TICK

def tick():
    look() or sleep(1)

//// WAIT

def wait(time):
    end = running_time() + time
    while running_time() < end:
        tick()
    look()

//// PAUSE

def pause(time):
    # Ends early if a behaviour has acted.
    end = running_time() + time
    while running_time() < end:
        if look():
            return
        sleep(1)

//// GO

def go(left, right, time):
@BACK@
    wheels(left, right)
    sleep(int(time + 0.5))
    wheels(0, 0)

//// GO, behaviours

def go(left, right, time):
    # A behaviour that acts stops it.
    global driving
@BACK@
    wheels(left, right)
    driving = True
    pause(int(time + 0.5))
    if driving:
        driving = False
        wheels(0, 0)
        look()

//// FORWARD

def forward(cm):
    go(@AHEAD@, @AHEAD@, cm * CM)

//// BACKWARD

def backward(cm):
    go(@BEHIND@, @BEHIND@, cm * CM)

//// TURN_LEFT

def turn_left(degrees):
    go(@BEHIND@, @AHEAD@, degrees * DEG)

//// TURN_RIGHT

def turn_right(degrees):
    go(@AHEAD@, @BEHIND@, degrees * DEG)

//// PEN_DOWN

def pen_down():
    servo(PEN_DOWN)
    @SLEEP@(200)@LOOK@

//// PEN_UP

def pen_up():
    servo(PEN_UP)
    @SLEEP@(200)@LOOK@

//// PLAY

def play(hertz, time):
    if time > 0:
        music.pitch(hertz, time, @PIN@wait=False)
        @WAIT@(time)

//// SHOW

def show(value):
    text = str(value)
    print(text)
    if len(text) == 1:
        display.show(text)
    else:
        display.scroll(text, wait=False)

//// DISTANCE

def distance():
    # Whole centimetres, 255 for nothing. A new echo is heard every 60 ms.
    global heard_at, heard
    now = running_time()
    if now - heard_at >= 60:
        heard_at = now
        @ECHO@.read_digital()
        @TRIGGER@.write_digital(1)
        sleep_us(10)
        @TRIGGER@.write_digital(0)@LISTEN@
        time = time_pulse_us(@ECHO@, 1, 15000)
        heard = 255 if time < 0 else min(255, time // 58)
    return heard
