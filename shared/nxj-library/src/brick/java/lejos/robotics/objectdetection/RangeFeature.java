package lejos.robotics.objectdetection;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.Transmittable;
import lejos.robotics.navigation.Pose;

/** A thing, or several, and how far away they are. */
public class RangeFeature implements Feature, Transmittable {
    private final Pose pose;
    private RangeReadings readings;
    private RangeReading reading;
    private long timeStamp = System.currentTimeMillis();

    /** Makes one of a thing. */
    public RangeFeature(RangeReading rr) {
        reading = rr;
        readings = new RangeReadings(0);
        readings.add(rr);
        pose = new Pose(0, 0, 0);
    }

    /** Makes one of several things, the nearest first. */
    public RangeFeature(RangeReadings rrs) {
        this(rrs, new Pose(0, 0, 0));
    }

    /** Makes one of several things, the nearest first, and of where the robot was. */
    public RangeFeature(RangeReadings rrs, Pose pose) {
        readings = rrs;
        reading = rrs.get(0);
        this.pose = pose;
    }

    /** Gives the nearest thing. */
    public RangeReading getRangeReading() {
        return reading;
    }

    /** Gives all things. */
    public RangeReadings getRangeReadings() {
        return readings;
    }

    /** Gives when it was found. */
    public long getTimeStamp() {
        return timeStamp;
    }

    /** Gives where the robot was; 0, 0 if nobody knew. */
    public Pose getPose() {
        return pose;
    }

    /** Writes where the robot was, how far away the nearest thing is, and when it was found. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        pose.dumpObject(dos);
        dos.writeFloat(reading.getRange());
        dos.writeLong(timeStamp);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        pose.loadObject(dis);
        reading = new RangeReading(0, dis.readFloat());
        timeStamp = dis.readLong();
    }
}
