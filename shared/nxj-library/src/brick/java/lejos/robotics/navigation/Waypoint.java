package lejos.robotics.navigation;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.geom.Point;
import lejos.robotics.Transmittable;

/** A point where a robot shall go, and perhaps where it shall look then. */
public class Waypoint extends Point implements Transmittable {
    /** Where the robot shall look, in degrees. */
    protected float heading;

    /** Whether it matters where the robot looks. */
    protected boolean headingRequired;

    /** How far away the robot may be; below 0 it does not matter. */
    protected float maxPositionError = -1;

    /** By how many degrees the robot may look elsewhere; below 0 it does not matter. */
    protected float maxHeadingError = -1;

    /** Makes one; it does not matter where the robot looks. */
    public Waypoint(double x, double y) {
        super((float) x, (float) y);
    }

    /** Makes one, with the degrees where the robot shall look. */
    public Waypoint(double x, double y, double heading) {
        super((float) x, (float) y);
        this.heading = (float) heading;
        headingRequired = true;
    }

    /** Makes one of a point; it does not matter where the robot looks. */
    public Waypoint(Point p) {
        super(p.x, p.y);
    }

    /** Makes one of where a robot is and looks. */
    public Waypoint(Pose p) {
        this(p.getX(), p.getY(), p.getHeading());
    }

    /** Gives where the robot shall look, in degrees. */
    public double getHeading() {
        return heading;
    }

    /** Says whether it matters where the robot looks. */
    public boolean isHeadingRequired() {
        return headingRequired;
    }

    /** Gives how far away the robot may be; below 0 it does not matter. */
    public double getMaxPositionError() {
        return maxPositionError;
    }

    /** Sets how far away the robot may be. */
    public void setMaxPositionError(double distance) {
        maxPositionError = (float) distance;
    }

    /** Gives by how many degrees the robot may look elsewhere; below 0 it does not matter. */
    public double getMaxHeadingError() {
        return maxHeadingError;
    }

    /** Sets by how many degrees the robot may look elsewhere. */
    public void setMaxHeadingError(double distance) {
        maxHeadingError = (float) distance;
    }

    /** Gives it as where a robot is and looks. */
    public Pose getPose() {
        return new Pose(x, y, heading);
    }

    /** Says whether a robot is near enough. */
    public boolean checkValidity(Pose p) {
        if (maxPositionError >= 0 && p.distanceTo(this) > maxPositionError) return false;
        return !headingRequired || maxHeadingError < 0 || Math.abs(p.getHeading() - heading) <= maxHeadingError;
    }

    /** Writes all of it. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(x);
        dos.writeFloat(y);
        dos.writeFloat(heading);
        dos.writeBoolean(headingRequired);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        x = dis.readFloat();
        y = dis.readFloat();
        heading = dis.readFloat();
        headingRequired = dis.readBoolean();
    }
}
