package josx.robotics;

/** An activity has to stop because a more important one wants the robot. */
public class StopException extends Exception {
    /** Makes one without a message. */
    public StopException() {
    }

    /** Makes one that says what went wrong. */
    public StopException(String message) {
        super(message);
    }
}
