package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.geom.Point;
import lejos.robotics.Transmittable;

/**
 * Where a robot is, and where it looks: degrees, counted to the left from the direction of x.
 *
 * <p>It keeps the degrees that it is given, such as 270. After a turn, they are above -180 and at most 180.
 */
public class Pose implements Transmittable {
    /** Up to so many degrees, a curve counts as straight. */
    private static final double STRAIGHT = 0.5;

    /** Up to this distance, a straight way counts as none. */
    private static final double SHORT = 0.01;

    /** The place. */
    protected Point _location;

    /** Where the robot looks, in degrees. */
    protected float _heading;

    /** Makes one at 0, 0 that looks in the direction of x. */
    public Pose() {
        this(0f, 0f, 0f);
    }

    /** Makes one of a place and the degrees where the robot looks. */
    public Pose(float x, float y, float heading) {
        _location = new Point(x, y);
        _heading = heading;
    }

    /** Turns by so many degrees. */
    public void rotateUpdate(float angle) {
        _heading += angle;
        while (_heading < 180) _heading += 360;
        while (_heading > 180) _heading -= 360;
    }

    /** Moves so far to where the robot looks. */
    public void moveUpdate(float distance) {
        double heading = Math.toRadians(_heading);
        translate(distance * (float) Math.cos(heading), distance * (float) Math.sin(heading));
    }

    /** Moves by so much. */
    public void translate(float dx, float dy) {
        _location.x += dx;
        _location.y += dy;
    }

    /** Moves so far in a circle while it turns by so many degrees. */
    public void arcUpdate(float distance, float turnAngle) {
        if (Math.abs(turnAngle) > STRAIGHT) {
            float turn = (float) Math.toRadians(turnAngle);
            float radius = distance / turn;
            double start = Math.toRadians(_heading);
            translate(radius * (float) (Math.sin(start + turn) - Math.sin(start)),
                radius * (float) (Math.cos(start) - Math.cos(start + turn)));
        } else if (Math.abs(distance) > SHORT) {
            moveUpdate(distance);
        }
        rotateUpdate(turnAngle);
    }

    /** Gives by how many degrees the robot has to turn, so that it looks at a point. */
    public float relativeBearing(Point destination) {
        float bearing = angleTo(destination) - _heading;
        if (bearing < -180) bearing += 360;
        if (bearing > 180) bearing -= 360;
        return bearing;
    }

    /** Gives the direction to a point in degrees. */
    public float angleTo(Point destination) {
        return _location.angleTo(destination);
    }

    /** Gives how far away a point is. */
    public float distanceTo(Point destination) {
        return (float) _location.distance(destination);
    }

    /** Gives the point that is so far away in a direction in degrees. */
    public Point pointAt(float distance, float bearing) {
        return _location.pointAt(distance, bearing);
    }

    /** Gives where the robot looks, in degrees. */
    public float getHeading() {
        return _heading;
    }

    /** Gives how far it is in the direction of x. */
    public float getX() {
        return _location.x;
    }

    /** Gives how far it is in the direction of y. */
    public float getY() {
        return _location.y;
    }

    /** Gives the place, which moves with the pose. */
    public Point getLocation() {
        return _location;
    }

    /** Moves it to another place. */
    public void setLocation(Point p) {
        _location = p;
    }

    /** Moves it to another place. */
    public void setLocation(float x, float y) {
        _location = new Point(x, y);
    }

    /** Sets the degrees where the robot looks. */
    public void setHeading(float heading) {
        _heading = heading;
    }

    /** Writes all of it. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(getX());
        dos.writeFloat(getY());
        dos.writeFloat(_heading);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        float x = dis.readFloat();
        setLocation(x, dis.readFloat());
        setHeading(dis.readFloat());
    }

    /** Gives it as text. */
    public String toString() {
        return "X:" + getX() + " Y:" + getY() + " H:" + _heading;
    }
}
