package lejos.robotics.navigation;

/** Tells how the robot moves. */
public interface MoveProvider {
    /** Gives how the robot has moved since it began to. */
    Move getMovement();

    /** Tells a listener from now on when a move begins and ends. */
    void addMoveListener(MoveListener listener);
}
