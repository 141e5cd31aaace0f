package lejos.robotics.navigation;

/** Drives a robot straight on and in circles, and turns it on the spot. */
public interface ArcRotateMoveController extends ArcMoveController, RotateMoveController {
}
