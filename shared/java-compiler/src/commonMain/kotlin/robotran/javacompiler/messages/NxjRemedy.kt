package robotran.javacompiler.messages

/** What a program does where an NXT with leJOS NXJ lacks what programs for computers or other robots use. */
enum class NxjRemedy {
    /** Write with `System.out.println`. */
    PRINT,

    /** Wait with `Delay.msDelay` or `Thread.sleep`. */
    WAIT,

    /** Ask the buttons: there is no keyboard. */
    BUTTONS,

    /** `Arrays.sort`, or a loop. */
    SORT_ARRAY,

    /** `HashMap`, which has no order. */
    HASH_MAP,

    /** `HashSet`, which has no order. */
    HASH_SET,

    /** `LinkedList`. */
    LINKED_LIST,

    /** A loop over the bits of a `BitSet`. */
    BITS,

    /** Files only: there are no folders. */
    NO_FOLDERS,
    OTHER_PROGRAM,

    /** A variable that keeps what was set. */
    OWN_VARIABLE,

    /** A new `ArrayList` and `add`. */
    FILL_LIST,

    /** A loop. */
    LOOP,

    /** An interface or a class of the program. */
    OWN_CLASS,

    /** `null` for what may be missing. */
    NULL,

    /** Join texts with `+`. */
    JOIN_TEXTS,

    /** `StringTokenizer`. */
    TOKENIZER,

    /** `equals`, `startsWith`, `indexOf` and `substring`. */
    COMPARE_TEXTS,

    /** `indexOf` for `contains`. */
    INDEX_OF,

    /** `substring` and `+` for what a `StringBuilder` lacks. */
    SUBSTRINGS,

    /** Compare characters with `'a'` and `'z'`. */
    COMPARE_CHARACTERS,

    /** Calculate it with what `Math` has. */
    CALCULATE,

    /** A loop that copies or compares elements; `System.arraycopy`. */
    ARRAY_LOOP,

    /** `Thread`, `Runnable` and `synchronized`. */
    THREADS,

    /** A variable that `run` looks at. */
    END_THREAD,

    /** `System.currentTimeMillis` or `Stopwatch`. */
    STOPWATCH,

    /** `long` or `double`. */
    LONG_OR_DOUBLE,

    /** `Random`. */
    RANDOM,

    /** `instanceof`: the brick forgets the names of classes. */
    INSTANCEOF,

    /** `LCD`: there are no windows. */
    LCD,

    /** `Graphics` of `javax.microedition.lcdui`. */
    PIXELS,

    /** `FileInputStream` and `FileOutputStream` with data streams. */
    FILE_STREAMS,

    /** `DataOutputStream` and `DataInputStream`. */
    DATA_STREAMS,

    /** `Bluetooth`. */
    BLUETOOTH,

    /** `Bluetooth.connect` with a robot's name: there is no chip and no list of devices. */
    BLUETOOTH_BY_NAME,

    /** `"\n"`. */
    LINE_FEED,

    /** `NXTMotor`, whose power a program sets. */
    NXT_MOTOR,

    /** Leave it out: the motor is always regulated. */
    ALWAYS_REGULATED,

    /** `forward`, `backward` and `stop`. */
    MOTOR_DIRECTIONS,

    /** `rotate`, by an angle. */
    MOTOR_ROTATE,

    /** `getRotationSpeed`. */
    ROTATION_SPEED,

    /** `isMoving`. */
    IS_MOVING,

    /** `DifferentialPilot`. */
    DIFFERENTIAL_PILOT,

    /** `setTravelSpeed` and `setRotateSpeed`. */
    PILOT_SPEEDS,

    /** `Navigator`. */
    NAVIGATOR,

    /** `OdometryPoseProvider`. */
    ODOMETRY,

    /** `LineMap`, made of lines. */
    LINE_MAP,

    /** `DifferentialPilot`: no robot can balance. */
    BALANCE,

    /** `RConsole`: no program runs on a computer beside the robot. */
    NO_COMPUTER,

    /** The sensors that a world can have. */
    SENSORS,

    /** `CompassHTSensor` or `CompassMindSensor`. */
    COMPASS,

    /** `GyroSensor`. */
    GYRO,

    /** `AccelHTSensor` or `AccelMindSensor`. */
    ACCELERATION,

    /** `UltrasonicSensor` or `OpticalDistanceSensor`. */
    DISTANCE,

    /** `getTachoCount` of a motor, or `RCXRotationSensor`. */
    COUNT_TURNS,

    /** `RCXThermometer`. */
    THERMOMETER,

    /** `RCXLink`. */
    RCX_LINK,

    /** A port for each sensor. */
    ONE_PORT_EACH,

    /** Leave it out: the settings of the menu hold. */
    MENU_SETTINGS,

    /** Listeners of buttons and ports instead of events of the machine. */
    NXT_LISTENERS,

    /** Breakpoints: a program cannot look into the virtual machine. */
    BREAKPOINTS,

    /** `Motor.A`, `Motor.B` and `Motor.C`: there are no other motors. */
    THREE_MOTORS,

    /** The program is for an EV3: import `lejos.nxt`. */
    NOT_EV3,

    /** `Motor.A`, not a motor of an EV3. */
    MOTOR_OF_PORT,

    /** The program is for an RCX: import `lejos.nxt`. */
    NOT_RCX,

    /** `LCD.drawInt` and `LCD.drawString` instead of the RCX's. */
    DRAW,

    /** `SensorPort` and a class for the sensor instead of the RCX's `Sensor`. */
    SENSOR_PORT,

    /** The NXT's buttons instead of the RCX's. */
    NXT_BUTTONS,
}
