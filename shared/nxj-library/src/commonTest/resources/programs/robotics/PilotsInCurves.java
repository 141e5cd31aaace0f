import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.robotics.navigation.DifferentialPilot;

public class PilotsInCurves {
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

    public static void main(String[] arguments) {
        Wheel left = new Wheel("L");
        Wheel right = new Wheel("R");
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.2, left, right);
        pilot.setTravelSpeed(20);
        pilot.arc(20, 90);
        System.out.println(told() + " " + left.getSpeed() + " " + right.getSpeed()); // expect Lr462 Rr822 230 409
        pilot.arc(-20, 90);
        System.out.println(told() + " " + left.getSpeed() + " " + right.getSpeed()); // expect Lr-822 Rr-462 409 230
        pilot.arc(20, -90);
        System.out.println(told()); // expect Lr-462 Rr-822
        pilot.arc(0, 45);
        System.out.println(told()); // expect Lr-90 Rr90
        pilot.travelArc(30, 15);
        System.out.println(told()); // expect Lr249 Rr364
        pilot.travelArc(Double.POSITIVE_INFINITY, 10);
        System.out.println(told()); // expect Lr204 Rr204
        try {
            pilot.travelArc(0, 10);
        } catch (IllegalArgumentException wrong) {
            System.out.println("no radius"); // expect no radius
        }
        pilot.steer(50);
        System.out.println(told() + " " + left.getSpeed() + " " + right.getSpeed()); // expect L+ R+ 205 409
        pilot.steer(-100);
        System.out.println(told()); // expect L+ R0
        pilot.steer(200);
        System.out.println(told()); // expect L- R+
        pilot.steer(0);
        System.out.println(told()); // expect L+ R+
        pilot.steerBackward(50);
        System.out.println(told()); // expect L- R-
        pilot.stop();
        System.out.println(told()); // expect L0 R0
        pilot.steer(50, 90);
        System.out.println(told()); // expect Lr360 Rr720
        pilot.steer(-50, -90, true);
        System.out.println(told()); // expect Lr720 Rr360
        pilot.arcForward(15);
        System.out.println(told()); // expect L+ R+
        pilot.arcBackward(-15);
        System.out.println(told()); // expect L- R-
        pilot.quickStop();
        System.out.println(told() + " " + left.getAcceleration()); // expect L0 R0 2558
        pilot.setMinRadius(7);
        System.out.println(pilot.getMinRadius()); // expect 7.0
    }
}
