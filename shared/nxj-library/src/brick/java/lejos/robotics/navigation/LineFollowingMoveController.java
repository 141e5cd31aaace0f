package lejos.robotics.navigation;

/** Drives a robot in curves that can change all the time. */
public interface LineFollowingMoveController extends MoveController {
    /** Drives forward in a curve: 0 straight on, 100 round the left wheel, -100 round the right one. */
    void steer(double turnRate);

    /** Drives backward in a curve. */
    void steerBackward(double turnRate);
}
