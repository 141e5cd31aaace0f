package lejos.robotics.localization;

import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/** Knows where the robot is by adding up its moves. */
public class OdometryPoseProvider implements PoseProvider, MoveListener {
    /** A turn of fewer degrees counts as none. */
    private static final float STRAIGHT = 0.2f;

    private final MoveProvider mp;
    private Pose pose = new Pose();

    /** What of the present move is in the pose already. */
    private float angle;
    private float distance;
    private boolean isMoving;

    /** Makes one that adds up the moves of a pilot; the robot is at 0, 0 and looks in the direction of x. */
    public OdometryPoseProvider(MoveProvider mp) {
        this.mp = mp;
        mp.addMoveListener(this);
    }

    /** Gives where the robot is and where it looks, also while it moves. */
    public synchronized Pose getPose() {
        if (isMoving) update(mp.getMovement());
        return new Pose(pose.getX(), pose.getY(), pose.getHeading());
    }

    /** Sets where the robot is and where it looks. */
    public synchronized void setPose(Pose aPose) {
        if (isMoving) update(mp.getMovement());
        pose = new Pose(aPose.getX(), aPose.getY(), aPose.getHeading());
    }

    /** Is told by the pilot; programs need not call it. */
    public synchronized void moveStarted(Move move, MoveProvider mp) {
        angle = 0;
        distance = 0;
        isMoving = true;
    }

    /** Is told by the pilot; programs need not call it. */
    public synchronized void moveStopped(Move move, MoveProvider mp) {
        if (isMoving) update(move);
        isMoving = false;
    }

    private void update(Move move) {
        float turned = move.getAngleTurned() - angle;
        float traveled = move.getDistanceTraveled() - distance;
        angle = move.getAngleTurned();
        distance = move.getDistanceTraveled();
        if (move.getMoveType() == Move.MoveType.ROTATE) {
            pose.rotateUpdate(turned);
        } else if (turned > -STRAIGHT && turned < STRAIGHT) {
            pose.moveUpdate(traveled);
            pose.rotateUpdate(turned);
        } else {
            pose.arcUpdate(traveled, turned);
        }
    }
}
