package lejos.robotics;

/** What every motor can do. */
public interface BaseMotor {
    /** Turns the motor forward until it is told otherwise. */
    void forward();

    /** Turns the motor backward until it is told otherwise. */
    void backward();

    /** Stops the motor. */
    void stop();

    /** Lets the motor roll on without power. */
    void flt();

    /** Says whether the motor moves. */
    boolean isMoving();
}
