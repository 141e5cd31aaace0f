import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.NavigationListener;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.pathfinding.Path;

public class Navigators {
    /** A motor that turns only while somebody waits for it, and writes down what it is told. */
    static class Wheel implements RegulatedMotor {
        private final String name;
        private int count;
        private int speed = 360;
        private int acceleration = 6000;
        private int direction;
        private int left;
        private RegulatedMotorListener listener;

        Wheel(String name) {
            this.name = name;
        }

        private void tell(String what) {
            LOG.append(name).append(what).append(' ');
        }

        private void begin(int newDirection) {
            direction = newDirection;
            if (listener != null) listener.rotationStarted(this, count, false, 0);
        }

        private void end() {
            boolean wasMoving = isMoving();
            direction = 0;
            left = 0;
            if (!wasMoving) return;
            if (listener != null) listener.rotationStopped(this, count, false, 0);
        }

        public void forward() {
            tell("+");
            begin(1);
        }

        public void backward() {
            tell("-");
            begin(-1);
        }

        public void stop() {
            stop(false);
        }

        public void stop(boolean immediateReturn) {
            tell("0");
            end();
        }

        public void flt() {
            flt(false);
        }

        public void flt(boolean immediateReturn) {
            tell("~");
            end();
        }

        public void rotate(int angle) {
            rotate(angle, false);
        }

        public void rotate(int angle, boolean immediateReturn) {
            tell("r" + angle);
            left = angle;
            begin(0);
            if (!immediateReturn) waitComplete();
        }

        public void rotateTo(int angle) {
            rotate(angle - count);
        }

        public void rotateTo(int angle, boolean immediateReturn) {
            rotate(angle - count, immediateReturn);
        }

        public int getLimitAngle() {
            return count + left;
        }

        public void waitComplete() {
            count += left;
            if (direction == 0) end();
        }

        public int getTachoCount() {
            return count;
        }

        public void resetTachoCount() {
            count = 0;
        }

        public int getRotationSpeed() {
            return direction * speed;
        }

        public void setSpeed(int newSpeed) {
            speed = newSpeed;
        }

        public int getSpeed() {
            return speed;
        }

        public float getMaxSpeed() {
            return 800;
        }

        public void setAcceleration(int newAcceleration) {
            acceleration = newAcceleration;
        }

        public int getAcceleration() {
            return acceleration;
        }

        public boolean isMoving() {
            return direction != 0 || left != 0;
        }

        public boolean isStalled() {
            return false;
        }

        public void setStallThreshold(int error, int time) {
        }

        public void addListener(RegulatedMotorListener newListener) {
            listener = newListener;
        }

        public RegulatedMotorListener removeListener() {
            RegulatedMotorListener old = listener;
            listener = null;
            return old;
        }
    }

    static final StringBuilder LOG = new StringBuilder();

    static String told() {
        String told = LOG.toString().trim();
        LOG.setLength(0);
        return told;
    }

    static String shown(Pose pose) {
        return Math.round(pose.getX()) + " " + Math.round(pose.getY()) + " " + Math.round(pose.getHeading());
    }

    public static void main(String[] arguments) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.2, new Wheel("L"), new Wheel("R"));
        Navigator navigator = new Navigator(pilot);
        navigator.addNavigationListener(new NavigationListener() {
            public void atWaypoint(Waypoint waypoint, Pose pose, int sequence) {
                System.out.println("at " + sequence + ": " + shown(pose));
            }

            public void pathComplete(Waypoint waypoint, Pose pose, int sequence) {
                System.out.println("complete " + sequence + ": " + shown(pose));
            }

            public void pathInterrupted(Waypoint waypoint, Pose pose, int sequence) {
                System.out.println("interrupted");
            }
        });
        System.out.println(navigator.getWaypoint() == null);
        navigator.goTo(60, 0);
        System.out.println(navigator.waitForStop());
        navigator.goTo(60, 80, 180);
        System.out.println(navigator.waitForStop());
        Path path = new Path();
        path.add(new Waypoint(0, 80));
        path.add(new Waypoint(0, 0, 0));
        navigator.followPath(path);
        System.out.println(navigator.waitForStop());
        System.out.println(shown(navigator.getPoseProvider().getPose()));
        System.out.println(navigator.pathCompleted() + " " + navigator.isMoving());
        System.out.println(navigator.rotateTo(450) + " " + shown(navigator.getPoseProvider().getPose()));
        System.out.println(navigator.rotateTo(-270) + " " + shown(navigator.getPoseProvider().getPose()));
        navigator.rotateTo(0);
        navigator.addWaypoint(20, 0);
        navigator.addWaypoint(40, 0);
        navigator.singleStep(true);
        navigator.followPath();
        navigator.waitForStop();
        System.out.println(shown(navigator.getPoseProvider().getPose()) + " " + navigator.pathCompleted());
        navigator.clearPath();
        System.out.println(navigator.pathCompleted());
    }
}

// It prints:
// expect true
// expect at 1: 60 0 0
// expect complete 1: 60 0 0
// expect true
// expect at 1: 61 80 180
// expect complete 1: 61 80 180
// expect true
// expect at 2: 0 80 180
// expect at 3: -1 0 0
// expect complete 3: -1 0 0
// expect true
// expect -1 0 0
// expect true false
// expect true -1 0 90
// expect true -1 0 90
// expect at 1: 20 0 0
// expect 20 0 0 false
// expect true
