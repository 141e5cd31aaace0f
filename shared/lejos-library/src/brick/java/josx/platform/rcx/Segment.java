package josx.platform.rcx;

/** The little pictures of the display, for LCD.setSegment and LCD.clearSegment. */
public interface Segment {
    /** The man who stands. */
    int STANDING = 0x3006;

    /** The man who walks. */
    int WALKING = 0x3007;

    /** The frame of sensor 1. */
    int SENSOR_1_VIEW = 0x3008;

    /** The mark that sensor 1 has power. */
    int SENSOR_1_ACTIVE = 0x3009;

    /** The frame of sensor 2. */
    int SENSOR_2_VIEW = 0x300A;

    /** The mark that sensor 2 has power. */
    int SENSOR_2_ACTIVE = 0x300B;

    /** The frame of sensor 3. */
    int SENSOR_3_VIEW = 0x300C;

    /** The mark that sensor 3 has power. */
    int SENSOR_3_ACTIVE = 0x300D;

    /** The frame of motor A. */
    int MOTOR_A_VIEW = 0x300E;

    /** The arrow of motor A backward. */
    int MOTOR_A_REV = 0x300F;

    /** The arrow of motor A forward. */
    int MOTOR_A_FWD = 0x3010;

    /** The frame of motor B. */
    int MOTOR_B_VIEW = 0x3011;

    /** The arrow of motor B backward. */
    int MOTOR_B_REV = 0x3012;

    /** The arrow of motor B forward. */
    int MOTOR_B_FWD = 0x3013;

    /** The frame of motor C. */
    int MOTOR_C_VIEW = 0x3014;

    /** The arrow of motor C backward. */
    int MOTOR_C_REV = 0x3015;

    /** The arrow of motor C forward. */
    int MOTOR_C_FWD = 0x3016;

    /** The quarters of a circle: each time shows one more. */
    int DATALOG = 0x3018;

    /** The dots that become more. */
    int DOWNLOAD = 0x3019;

    /** The dots that become fewer. */
    int UPLOAD = 0x301A;

    /** The empty battery. */
    int BATTERY = 0x301B;

    /** The short beam of infrared light. */
    int RANGE_SHORT = 0x301C;

    /** The long beam of infrared light. */
    int RANGE_LONG = 0x301D;

    /** Everything. */
    int ALL = 0x3020;
}
