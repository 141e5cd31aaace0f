package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.Transmittable;

/** How a robot moves: how far, and by how many degrees it turns. */
public class Move implements Transmittable {
    /** Turns by less degrees than this have no radius. */
    private static final double LEAST_ANGLE = 0.5;

    /** The kinds of moves. */
    public enum MoveType {
        /** Straight on. */
        TRAVEL,
        /** A turn on the spot. */
        ROTATE,
        /** In a circle. */
        ARC,
        /** Not at all. */
        STOP
    }

    /** How far the robot moves. */
    protected float distanceTraveled;

    /** By how many degrees the robot turns. */
    protected float angleTurned;

    /** Which kind of move it is. */
    protected MoveType moveType;

    /** The radius of the circle. */
    protected float arcRadius = Float.POSITIVE_INFINITY;

    /** Whether the robot moves now. */
    protected boolean isMoving;

    /** When the move was made. */
    protected long timeStamp;

    /** How far the robot moves in a second. */
    protected float travelSpeed;

    /** How many degrees the robot turns in a second. */
    protected float rotateSpeed;

    /** Makes one of a kind. */
    public Move(MoveType type, float distance, float angle, float travelSpeed, float rotateSpeed, boolean isMoving) {
        this.travelSpeed = travelSpeed;
        this.rotateSpeed = rotateSpeed;
        set(type, distance, angle, isMoving);
    }

    /** Makes one of a kind without speeds. */
    public Move(MoveType type, float distance, float angle, boolean isMoving) {
        this(type, distance, angle, 0f, 0f, isMoving);
    }

    /** Makes one whose kind follows from how far the robot moves and turns. */
    public Move(float distance, float angle, boolean isMoving) {
        this(typeOf(distance, angle), distance, angle, isMoving);
    }

    /** Makes one of the degrees of a turn and the radius of the circle; 0 is for a turn on the spot. */
    public Move(boolean isMoving, float angle, float turnRadius) {
        this(convertAngleToDistance(angle, turnRadius), angle, isMoving);
        arcRadius = turnRadius;
    }

    /** Gives the degrees of a turn for so far on a circle. */
    public static float convertDistanceToAngle(float distance, float radius) {
        return (float) (distance * 180 / (Math.PI * radius));
    }

    /** Gives how far it is on a circle for the degrees of a turn. */
    public static float convertAngleToDistance(float angle, float radius) {
        return (float) (angle * Math.PI * radius / 180);
    }

    /** Changes everything but the speeds; the kind follows from how far the robot moves and turns. */
    public void setValues(MoveType type, float distance, float angle, boolean isMoving) {
        set(typeOf(distance, angle), distance, angle, isMoving);
    }

    private void set(MoveType type, float distance, float angle, boolean isMoving) {
        moveType = type;
        distanceTraveled = distance;
        angleTurned = angle;
        this.isMoving = isMoving;
        timeStamp = System.currentTimeMillis();
        if (Math.abs(angle) > LEAST_ANGLE) arcRadius = (float) (distance / Math.toRadians(angle));
    }

    /** Writes the kind, the speeds, how far the robot moves, and by how many degrees it turns. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeByte(moveType.ordinal());
        dos.writeFloat(travelSpeed);
        dos.writeFloat(rotateSpeed);
        dos.writeFloat(distanceTraveled);
        dos.writeFloat(angleTurned);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        moveType = MoveType.values()[dis.readByte()];
        travelSpeed = dis.readFloat();
        rotateSpeed = dis.readFloat();
        distanceTraveled = dis.readFloat();
        angleTurned = dis.readFloat();
    }

    /**
     * Changes the speeds.
     *
     * @hidden
     */
    public void setDynamics(float travelSpeed, float rotateSpeed) {
        this.travelSpeed = travelSpeed;
        this.rotateSpeed = rotateSpeed;
    }

    /** Gives how far the robot moves, backward if there is a minus. */
    public float getDistanceTraveled() {
        return distanceTraveled;
    }

    /** Gives by how many degrees the robot turns, to the right if there is a minus. */
    public float getAngleTurned() {
        return angleTurned;
    }

    /** Gives which kind of move it is. */
    public MoveType getMoveType() {
        return moveType;
    }

    /** Gives the radius of the circle, with a minus if its centre is on the right. */
    public float getArcRadius() {
        return arcRadius;
    }

    /** Says whether the robot moves now. */
    public boolean isMoving() {
        return isMoving;
    }

    /** Gives when the move was made. */
    public long getTimeStamp() {
        return timeStamp;
    }

    /** Gives how far the robot moves in a second. */
    public float getTravelSpeed() {
        return travelSpeed;
    }

    /** Gives how many degrees the robot turns in a second. */
    public float getRotateSpeed() {
        return rotateSpeed;
    }

    /** Gives the move as text. */
    public String toString() {
        switch (moveType) {
            case TRAVEL:
                return "TRAVEL " + distanceTraveled + " at " + travelSpeed;
            case ROTATE:
                return "ROTATE " + angleTurned + " at " + rotateSpeed;
            case ARC:
                return "ARC  of " + arcRadius + " for " + angleTurned + "degrees  at " + travelSpeed;
            default:
                return "STOP ";
        }
    }

    private static MoveType typeOf(float distance, float angle) {
        if (distance == 0) return angle == 0 ? MoveType.STOP : MoveType.ROTATE;
        return angle == 0 ? MoveType.TRAVEL : MoveType.ARC;
    }
}
