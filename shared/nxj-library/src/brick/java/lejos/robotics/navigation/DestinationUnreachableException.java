package lejos.robotics.navigation;

/** There is no way for the robot to get there. */
public class DestinationUnreachableException extends Exception {
    /** Makes one. */
    public DestinationUnreachableException() {
    }
}
