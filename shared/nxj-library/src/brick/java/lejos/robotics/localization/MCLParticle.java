package lejos.robotics.localization;

import java.util.Random;
import lejos.geom.Point;
import lejos.robotics.RangeReadings;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;

/** A guess of where a robot is, with a weight from 0 to 1 that says how likely it is. */
public class MCLParticle {
    private static final Random random = new Random();
    private static boolean isTelling;

    private final Pose pose;
    private float weight = 1;

    /** Makes one of where the robot may be and look. */
    public MCLParticle(Pose pose) {
        this.pose = pose;
    }

    /** Says whether to write on the display why a guess cannot be. */
    public static void setDebug(boolean yes) {
        isTelling = yes;
    }

    /** Sets how likely it is. */
    public void setWeight(float weight) {
        this.weight = weight;
    }

    /** Gives how likely it is. */
    public float getWeight() {
        return weight;
    }

    /** Gives where the robot may be and look. */
    public Pose getPose() {
        return pose;
    }

    /** Works out how likely it is, from what was measured and what the map says; a larger divisor forgives more. */
    public void calculateWeight(RangeReadings rr, RangeMap map, float divisor) {
        weight = 1;
        Pose looking = new Pose();
        looking.setLocation(pose.getLocation());
        for (int i = 0; i < rr.getNumReadings(); i++) {
            if (!map.inside(looking.getLocation())) {
                weight = 0;
                return;
            }
            looking.setHeading(pose.getHeading() + rr.getAngle(i));
            float range = map.range(looking);
            if (range < 0) {
                weight = 0;
                if (isTelling) System.out.println("zero wt" + looking);
                return;
            }
            float difference = rr.getRange(i) - range;
            weight *= (float) Math.exp(-(difference * difference) / divisor);
        }
    }

    /** Gives what the map says for the direction at a place of what was measured. */
    public float getReading(int i, RangeReadings rr, RangeMap map) {
        Pose looking = new Pose();
        looking.setLocation(pose.getLocation());
        looking.setHeading(pose.getHeading() + rr.getAngle(i));
        return map.range(looking);
    }

    /** Gives what the map says for all directions of what was measured. */
    public RangeReadings getReadings(RangeReadings rr, RangeMap map) {
        RangeReadings read = new RangeReadings(rr.getNumReadings());
        for (int i = 0; i < rr.getNumReadings(); i++) read.setRange(i, rr.getAngle(i), getReading(i, rr, map));
        return read;
    }

    /** Moves the guess as the robot has moved, straight on or on the spot, and by chance a little otherwise. */
    public void applyMove(Move move, float distanceNoiseFactor, float angleNoiseFactor) {
        double angle = Math.toRadians(pose.getHeading());
        float up = move.getDistanceTraveled() * (float) Math.sin(angle);
        float across = move.getDistanceTraveled() * (float) Math.cos(angle);
        float x = (float) (pose.getX() + across + distanceNoiseFactor * across * random.nextGaussian());
        float y = (float) (pose.getY() + up + distanceNoiseFactor * up * random.nextGaussian());
        pose.setLocation(new Point(x, y));
        float heading = (float) (pose.getHeading() + move.getAngleTurned() + angleNoiseFactor * random.nextGaussian());
        pose.setHeading((int) (heading + 0.5f) % 360);
    }
}
