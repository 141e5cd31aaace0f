package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.geom.Point;
import lejos.robotics.Transmittable;

/** Where a robot is, and where it looks: degrees, counted to the left from the direction of x. */
public class Pose implements Transmittable {
    /** The place. */
    protected Point _location;

    /** Where the robot looks, -180 to 180 degrees. */
    protected float _heading;

    /** Makes one at 0, 0 that looks in the direction of x. */
    public Pose() {
        this(0f, 0f, 0f);
    }

    /** Makes one of a place and the degrees where the robot looks. */
    public Pose(float x, float y, float heading) {
        _location = new Point(x, y);
        setHeading(heading);
    }

    /** Turns by so many degrees. */
    public void rotateUpdate(float angle) {
        setHeading(_heading + angle);
    }

    /** Moves so far to where the robot looks. */
    public void moveUpdate(float distance) {
        _location = pointAt(distance, _heading);
    }

    /** Moves by so much. */
    public void translate(float dx, float dy) {
        setLocation(getX() + dx, getY() + dy);
    }

    /** Moves so far in a circle while it turns by so many degrees. */
    public void arcUpdate(float distance, float turnAngle) {
        if (turnAngle == 0) {
            moveUpdate(distance);
            return;
        }
        double radius = Math.toDegrees(distance / turnAngle);
        double start = Math.toRadians(_heading);
        double end = Math.toRadians(_heading + turnAngle);
        translate((float) (radius * (Math.sin(end) - Math.sin(start))),
            (float) (radius * (Math.cos(start) - Math.cos(end))));
        rotateUpdate(turnAngle);
    }

    /** Gives by how many degrees the robot has to turn, so that it looks at a point. */
    public float relativeBearing(Point destination) {
        return normalize(angleTo(destination) - _heading);
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

    /** Gives where the robot looks, -180 to 180 degrees. */
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

    /** Gives the place. */
    public Point getLocation() {
        return new Point(getX(), getY());
    }

    /** Moves it to another place. */
    public void setLocation(Point p) {
        setLocation(p.x, p.y);
    }

    /** Moves it to another place. */
    public void setLocation(float x, float y) {
        _location = new Point(x, y);
    }

    /** Sets the degrees where the robot looks. */
    public void setHeading(float heading) {
        _heading = normalize(heading);
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

    private static float normalize(float angle) {
        float rest = angle % 360f;
        if (rest > 180f) return rest - 360f;
        return rest < -180f ? rest + 360f : rest;
    }
}
