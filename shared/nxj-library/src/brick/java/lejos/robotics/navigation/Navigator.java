package lejos.robotics.navigation;

import java.util.ArrayList;
import lejos.robotics.localization.OdometryPoseProvider;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.pathfinding.Path;

/**
 * Drives a robot from point to point, in a thread of its own.
 *
 * <p>The program goes on at once and may end while the robot still drives: call waitForStop before that.
 */
public class Navigator implements WaypointListener {
    /** The degrees below which a way to the side counts as straight on. */
    private static final float STRAIGHT = 0.5f;

    private final MoveController pilot;
    private final ArrayList<NavigationListener> listeners = new ArrayList<NavigationListener>();
    private PoseProvider poseProvider;
    private Path path = new Path();
    private boolean isDriving;
    private boolean isSingleStep;
    private boolean isInterrupted;
    private int sequence;

    /** Where the robot drives to or was driving to last; null before the first point. */
    private Waypoint destination;

    /** Makes one of a pilot, whose moves it adds up to know where the robot is. */
    public Navigator(MoveController pilot) {
        this(pilot, null);
    }

    /** Makes one of a pilot and of what knows where the robot is. */
    public Navigator(MoveController pilot, PoseProvider poseProvider) {
        this.pilot = pilot;
        this.poseProvider = poseProvider == null ? new OdometryPoseProvider(pilot) : poseProvider;
        Thread driver = new Driver();
        driver.setDaemon(true);
        driver.start();
    }

    /** Sets what knows where the robot is. */
    public void setPoseProvider(PoseProvider poseProvider) {
        this.poseProvider = poseProvider;
    }

    /** Gives what knows where the robot is. */
    public PoseProvider getPoseProvider() {
        return poseProvider;
    }

    /** Gives the pilot. */
    public MoveController getMoveController() {
        return pilot;
    }

    /** Tells a listener from now on how far the robot is. */
    public void addNavigationListener(NavigationListener listener) {
        listeners.add(listener);
    }

    /** Sets all points, which the robot will follow once followPath is called. */
    public synchronized void setPath(Path path) {
        if (isDriving) stop();
        this.path = path;
        isSingleStep = false;
        sequence = 0;
    }

    /** Takes all points away, also from a path that was given to followPath. */
    public synchronized void clearPath() {
        if (isDriving) stop();
        path.clear();
    }

    /** Gives all points that are still to come. */
    public Path getPath() {
        return path;
    }

    /** Sets all points, and begins to drive. */
    public void followPath(Path path) {
        this.path = path;
        followPath();
    }

    /** Begins to drive from point to point. */
    public synchronized void followPath() {
        if (path.isEmpty()) return;
        isInterrupted = false;
        isDriving = true;
        notifyAll();
    }

    /** Says whether to stop at each point until followPath is called again. */
    public void singleStep(boolean yes) {
        isSingleStep = yes;
    }

    /** Adds a point, and begins to drive. */
    public void goTo(Waypoint destination) {
        addWaypoint(destination);
        followPath();
    }

    /** Adds a point, and begins to drive. */
    public void goTo(float x, float y) {
        goTo(new Waypoint(x, y));
    }

    /** Adds a point and where to look there, and begins to drive. */
    public void goTo(float x, float y, float heading) {
        goTo(new Waypoint(x, y, heading));
    }

    /** Adds a point. */
    public void addWaypoint(float x, float y) {
        addWaypoint(new Waypoint(x, y));
    }

    /** Adds a point and where to look there. */
    public void addWaypoint(float x, float y, float heading) {
        addWaypoint(new Waypoint(x, y, heading));
    }

    /** Adds a point. */
    public synchronized void addWaypoint(Waypoint waypoint) {
        if (path.isEmpty()) {
            sequence = 0;
            isSingleStep = false;
        }
        path.add(waypoint);
    }

    /** Is told that there are no further points; nothing happens. */
    public void pathGenerated() {
    }

    /** Turns on the spot until the robot looks there, and waits; says false, and does nothing, if it is on its way. */
    public boolean rotateTo(double angle) {
        double turn = angle - poseProvider.getPose().getHeading();
        while (turn > 180) turn -= 360;
        while (turn < -180) turn += 360;
        if (isDriving) return false;
        if (pilot instanceof RotateMoveController) ((RotateMoveController) pilot).rotate(turn);
        return true;
    }

    /** Stops the robot; followPath goes on. */
    public void stop() {
        isDriving = false;
        isInterrupted = true;
        pilot.stop();
        tell(destination);
    }

    /** Says whether the robot is on its way. */
    public boolean isMoving() {
        return isDriving;
    }

    /** Says whether there are no more points. */
    public boolean pathCompleted() {
        return path.isEmpty();
    }

    /** Waits until the robot stops, and says whether there are no more points. */
    public synchronized boolean waitForStop() {
        while (isDriving) {
            try {
                wait(20);
            } catch (InterruptedException goOnWaiting) {
                // Only the robot knows when it stops.
            }
        }
        return pathCompleted();
    }

    /** Gives the next point, or null. */
    public Waypoint getWaypoint() {
        return path.isEmpty() ? null : path.get(0);
    }

    private void tell(Waypoint waypoint) {
        Pose pose = poseProvider.getPose();
        for (NavigationListener listener : listeners) {
            if (isInterrupted) {
                listener.pathInterrupted(waypoint, pose, sequence);
            } else {
                listener.atWaypoint(waypoint, pose, sequence);
                if (path.isEmpty()) listener.pathComplete(waypoint, pose, sequence);
            }
        }
    }

    private void driveTo(Waypoint destination) {
        Pose pose = poseProvider.getPose();
        float bearing = pose.relativeBearing(destination);
        float distance = pose.distanceTo(destination);
        if (!(pilot instanceof RotateMoveController)) {
            driveArcTo(bearing, distance);
            return;
        }
        ((RotateMoveController) pilot).rotate(bearing, false);
        if (!isDriving) return;
        pilot.travel(poseProvider.getPose().distanceTo(destination), false);
        if (isDriving && destination.isHeadingRequired()) {
            // As on a brick, this can be the long way round.
            ((RotateMoveController) pilot).rotate(destination.getHeading() - poseProvider.getPose().getHeading());
        }
    }

    /** Drives in one circle to the point. */
    private void driveArcTo(float bearing, float distance) {
        if (bearing < STRAIGHT && bearing > -STRAIGHT || !(pilot instanceof ArcMoveController)) {
            pilot.travel(distance, false);
        } else {
            double radius = distance / (2 * Math.sin(Math.toRadians(bearing)));
            ((ArcMoveController) pilot).arc(radius, 2 * bearing, false);
        }
    }

    private synchronized Waypoint awaitNext() {
        while (!isDriving || path.isEmpty()) {
            try {
                wait();
            } catch (InterruptedException lookAgain) {
                // Nobody has this thread to interrupt it.
            }
        }
        destination = path.get(0);
        return destination;
    }

    /** Is at the point, unless somebody has stopped the robot. */
    private void arrive(Waypoint waypoint) {
        synchronized (this) {
            if (!isDriving || path.isEmpty() || path.get(0) != waypoint) return;
            path.remove(0);
            sequence++;
        }
        tell(waypoint);
        synchronized (this) {
            if (path.isEmpty() || isSingleStep) isDriving = false;
            notifyAll();
        }
    }

    private class Driver extends Thread {
        Driver() {
        }

        public void run() {
            while (true) {
                Waypoint next = awaitNext();
                driveTo(next);
                arrive(next);
            }
        }
    }
}
