package lejos.robotics.localization;

import java.awt.Rectangle;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import lejos.robotics.RangeReadings;
import lejos.robotics.RangeScanner;
import lejos.robotics.Transmittable;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/**
 * Works out where a robot is from its moves, from what it measures around it, and from a map (Monte Carlo).
 *
 * <p>It has many guesses. Each move moves all of them. getPose measures if the robot has moved since, keeps the
 * guesses for which the map fits, and gives their middle. Its thread never ends: end the program by System.exit or
 * by ENTER and ESCAPE.
 */
public class MCLPoseProvider implements PoseProvider, MoveListener, Transmittable {
    private static final float FAR = 1000000;
    private static final float LEAST_WEIGHT = 0.3f;

    private final RangeScanner scanner;
    private final int border;
    private final ArrayList<Move> moves = new ArrayList<Move>();
    private RangeMap map;
    private int numParticles;
    private MCLParticleSet particles;
    private RangeReadings readings;
    private boolean isUpdated;
    private boolean isIncomplete = true;
    private boolean isBusy;
    private boolean isTelling;

    private float x;
    private float y;
    private float heading;
    private float minX;
    private float maxX;
    private float minY;
    private float maxY;
    private double varX;
    private double varY;
    private double varHeading;

    /** Makes one that is told of moves, with a scanner, a map, so many guesses, and how far they are from its edge. */
    public MCLPoseProvider(MoveProvider mp, RangeScanner scanner, RangeMap map, int numParticles, int border) {
        this.numParticles = numParticles;
        this.border = border;
        this.scanner = scanner;
        this.map = map;
        if (numParticles > 0 && map != null) generateParticles();
        if (mp != null) mp.addMoveListener(this);
        new Mover().start();
    }

    /** Makes one that only holds guesses. */
    public MCLPoseProvider(RangeMap map, int numParticles, int border) {
        this.numParticles = numParticles;
        this.border = border;
        this.map = map;
        scanner = null;
    }

    /** Sets the map. */
    public void setMap(RangeMap map) {
        this.map = map;
    }

    /** Makes guesses around a place, so far away and turned by so many degrees as a rule. */
    public void setInitialPose(Pose aPose, float radiusNoise, float headingNoise) {
        x = aPose.getX();
        y = aPose.getY();
        heading = aPose.getHeading();
        particles = new MCLParticleSet(map, numParticles, aPose, radiusNoise, headingNoise);
    }

    /** Makes guesses that are likely after what was measured, if the sensor is wrong by so much as a rule. */
    public void setInitialPose(RangeReadings readings, float sigma) {
        tell("MCLPP set Initial pose called ");
        particles = new MCLParticleSet(map, numParticles, border, readings, 2 * sigma * sigma, LEAST_WEIGHT);
        isUpdated = true;
    }

    /** Says whether to write on the display what happens. */
    public void setDebug(boolean on) {
        isTelling = on;
    }

    private void tell(String text) {
        if (isTelling) System.out.println(text);
    }

    /** Makes guesses very near to a place, so that getPose does not measure until the next move. */
    public void setPose(Pose aPose) {
        setInitialPose(aPose, 1, 1);
        isUpdated = true;
    }

    /** Gives the guesses. */
    public MCLParticleSet getParticles() {
        return particles;
    }

    /** Sets the guesses. */
    public void setParticles(MCLParticleSet particles) {
        this.particles = particles;
        numParticles = particles.numParticles();
    }

    /** Makes new guesses anywhere in the map. */
    public void generateParticles() {
        particles = new MCLParticleSet(map, numParticles, border);
    }

    /** Is told by the pilot; programs need not call it. */
    public void moveStarted(Move event, MoveProvider mp) {
        isUpdated = false;
    }

    /** Is told by the pilot; programs need not call it. */
    public void moveStopped(Move event, MoveProvider mp) {
        tell("MCL move stopped");
        isUpdated = false;
        moves.add(event);
    }

    /** Measures, and keeps the guesses that fit; false if something was not measured, or if none fits. */
    public boolean update() {
        tell("MCLPP update called ");
        isUpdated = false;
        if (scanner == null) return false;
        readings = scanner.getRangeValues();
        isIncomplete = readings.incomplete();
        return !isIncomplete && update(readings);
    }

    /** Keeps the guesses that fit what was measured; false if something was not measured, or if none fits. */
    public boolean update(RangeReadings readings) {
        tell("MCLPP update readings called ");
        isUpdated = false;
        isIncomplete = readings.incomplete();
        if (isIncomplete) return false;
        tell("update readings incomplete " + isIncomplete);
        boolean isLikely = particles.calculateWeights(readings, map);
        tell(" max Weight " + particles.getMaxWeight() + " Good pose " + isLikely);
        if (!isLikely) {
            tell("Sensor data improbable from this pose ");
            return false;
        }
        isUpdated = particles.resample();
        tell(isUpdated ? "Resample done" : "Resample failed");
        return isUpdated;
    }

    /** Tells whether guesses fit since the last move. */
    public boolean isUpdated() {
        return isUpdated;
    }

    /** Gives false, as in leJOS NXJ. */
    public boolean isLost() {
        return false;
    }

    /** Tells whether something was not measured. */
    public boolean incompleteRanges() {
        return isIncomplete;
    }

    /** Tells whether the guesses are being moved. */
    public boolean isBusy() {
        return isBusy;
    }

    /** Measures if the robot has moved since, and gives the middle of all guesses. */
    public Pose getPose() {
        tell("Mcl call update; updated? " + isUpdated + " busy " + isBusy);
        if (!isUpdated) {
            while (isBusy) {
                tell("MCL Busy");
                Thread.yield();
            }
            tell("Mcl call update; updated? " + isUpdated);
            if (!isUpdated) update();
        }
        estimatePose();
        return getEstimatedPose();
    }

    /** Gives the middle of all guesses as it was worked out last. */
    public Pose getEstimatedPose() {
        return new Pose(x, y, heading);
    }

    /** Works out the middle of all guesses, and how far they are from it. */
    public void estimatePose() {
        float sumX = 0;
        float sumY = 0;
        float sumHeading = 0;
        varX = 0;
        varY = 0;
        varHeading = 0;
        minX = FAR;
        minY = FAR;
        maxX = -FAR;
        maxY = -FAR;
        for (int i = 0; i < numParticles; i++) {
            Pose pose = particles.getParticle(i).getPose();
            float px = pose.getX();
            float py = pose.getY();
            float angle = pose.getHeading();
            sumX += px;
            varX += px * px;
            sumY += py;
            varY += py * py;
            sumHeading += angle;
            varHeading += angle * angle;
            minX = Math.min(minX, px);
            maxX = Math.max(maxX, px);
            minY = Math.min(minY, py);
            maxY = Math.max(maxY, py);
        }
        x = sumX / numParticles;
        varX = varX / numParticles - x * x;
        y = sumY / numParticles;
        varY = varY / numParticles - y * y;
        heading = sumHeading / numParticles;
        varHeading = varHeading / numParticles - heading * heading;
        while (heading > 180) heading -= 360;
        while (heading < -180) heading += 360;
    }

    /** Gives what was measured last. */
    public RangeReadings getReadings() {
        return readings;
    }

    /** Gives what was measured last. */
    public RangeReadings getRangeReadings() {
        return readings;
    }

    /** Gives the rectangle around all guesses. */
    public Rectangle getErrorRect() {
        return new Rectangle((int) minX, (int) minY, (int) (maxX - minX), (int) (maxY - minY));
    }

    /** Gives the largest x of the guesses. */
    public float getMaxX() {
        return maxX;
    }

    /** Gives the smallest x of the guesses. */
    public float getMinX() {
        return minX;
    }

    /** Gives the largest y of the guesses. */
    public float getMaxY() {
        return maxY;
    }

    /** Gives the smallest y of the guesses. */
    public float getMinY() {
        return minY;
    }

    /** Gives how far the guesses spread along x. */
    public float getXRange() {
        return maxX - minX;
    }

    /** Gives how far the guesses spread along y. */
    public float getYRange() {
        return maxY - minY;
    }

    /** Gives the standard deviation of x. */
    public float getSigmaX() {
        return (float) Math.sqrt(varX);
    }

    /** Gives the standard deviation of y. */
    public float getSigmaY() {
        return (float) Math.sqrt(varY);
    }

    /** Gives the standard deviation of where the robot looks, in degrees. */
    public float getSigmaHeading() {
        return (float) Math.sqrt(varHeading);
    }

    /** Gives the scanner. */
    public RangeScanner getScanner() {
        return scanner;
    }

    /** Writes the middle of the guesses and how far they spread. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(x);
        dos.writeFloat(y);
        dos.writeFloat(heading);
        dos.writeFloat(minX);
        dos.writeFloat(maxX);
        dos.writeFloat(minY);
        dos.writeFloat(maxY);
        dos.writeFloat((float) varX);
        dos.writeFloat((float) varY);
        dos.writeFloat((float) varHeading);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        x = dis.readFloat();
        y = dis.readFloat();
        heading = dis.readFloat();
        minX = dis.readFloat();
        maxX = dis.readFloat();
        minY = dis.readFloat();
        maxY = dis.readFloat();
        varX = dis.readFloat();
        varY = dis.readFloat();
        varHeading = dis.readFloat();
        tell("Estimate = " + minX + " , " + maxX + " , " + minY + " , " + maxY);
    }

    /** Moves the guesses, one move after the other. */
    private class Mover extends Thread {
        Mover() {
        }

        public void run() {
            while (true) {
                while (!moves.isEmpty()) {
                    tell("Updater move stop " + moves.get(0).getMoveType());
                    isBusy = true;
                    particles.applyMove(moves.get(0));
                    tell("applied move ");
                    moves.remove(0);
                }
                isBusy = false;
                Thread.yield();
            }
        }
    }
}
