import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.robotics.localization.OdometryPoseProvider;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.Pose;

public class Odometry {
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
        OdometryPoseProvider odometry = new OdometryPoseProvider(pilot);
        System.out.println(shown(odometry.getPose())); // expect 0 0 0
        pilot.travel(50);
        System.out.println(shown(odometry.getPose())); // expect 50 0 0
        pilot.rotate(90);
        System.out.println(shown(odometry.getPose())); // expect 50 0 90
        pilot.travel(30);
        System.out.println(shown(odometry.getPose())); // expect 50 30 90
        pilot.arc(20, 180);
        System.out.println(shown(odometry.getPose())); // expect 10 30 -90
        pilot.travel(-10);
        System.out.println(shown(odometry.getPose())); // expect 10 40 -90
        for (int side = 0; side < 4; side++) {
            pilot.travel(100);
            pilot.rotate(-90);
        }
        System.out.println(shown(odometry.getPose())); // expect 10 40 -90
        odometry.setPose(new Pose(1, 2, 45));
        pilot.travel(14.142);
        System.out.println(shown(odometry.getPose())); // expect 11 12 45
    }
}
