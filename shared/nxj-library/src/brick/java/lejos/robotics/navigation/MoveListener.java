package lejos.robotics.navigation;

/** Is told when a move of the robot begins and ends. */
public interface MoveListener {
    /** A move begins, and this is how far it is to go. */
    void moveStarted(Move event, MoveProvider mp);

    /** A move has ended, and this is how far it went. */
    void moveStopped(Move event, MoveProvider mp);
}
