import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;

public class Pilots {
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
        System.out.println(Math.round(pilot.getMaxTravelSpeed() * 100) + " " + Math.round(pilot.getTravelSpeed() * 100));
        System.out.println(Math.round(pilot.getMaxRotateSpeed()) + " " + Math.round(pilot.getRotateSpeed()));
        System.out.println(left.getSpeed() + " " + right.getSpeed());
        pilot.setTravelSpeed(20);
        pilot.setRotateSpeed(90);
        System.out.println(left.getSpeed());
        pilot.travel(10);
        System.out.println(told() + " " + left.getSpeed());
        System.out.println(Math.round(pilot.getMovementIncrement() * 10) + " " + Math.round(pilot.getAngleIncrement()));
        pilot.travel(-5, true);
        System.out.println(told());
        pilot.rotate(90);
        System.out.println(told() + " " + left.getSpeed());
        System.out.println(Math.round(pilot.getAngleIncrement()));
        pilot.rotate(-45);
        System.out.println(told());
        pilot.forward();
        System.out.println(told() + " " + pilot.isMoving());
        pilot.stop();
        System.out.println(told() + " " + pilot.isMoving());
        pilot.backward();
        pilot.stop();
        System.out.println(told());
        pilot.rotateLeft();
        pilot.rotateRight();
        pilot.stop();
        System.out.println(told());
        DifferentialPilot reversed = new DifferentialPilot(5.6, 11.2, left, right, true);
        reversed.travel(10);
        System.out.println(told());
        System.out.println(Math.round(reversed.getMovementIncrement() * 10));
        DifferentialPilot uneven = new DifferentialPilot(5.0, 6.0, 12, left, right, false);
        uneven.travel(10);
        System.out.println(told());
        uneven.rotate(90);
        System.out.println(told());
        pilot = new DifferentialPilot(5.6f, 11.2f, left, right);
        pilot.addMoveListener(new MoveListener() {
            public void moveStarted(Move move, MoveProvider provider) {
                System.out.println("start " + move.getMoveType() + " " + move.isMoving());
            }

            public void moveStopped(Move move, MoveProvider provider) {
                int turned = Math.round(move.getAngleTurned());
                System.out.println("stop " + Math.round(move.getDistanceTraveled()) + " " + turned);
            }
        });
        pilot.travel(30);
        pilot.rotate(180);
    }
}

// It prints:
// expect 3910 3128
// expect 400 320
// expect 640 640
// expect 180
// expect Lr204 Rr204 409
// expect 100 0
// expect Lr-102 Rr-102
// expect Lr-180 Rr180 180
// expect 90
// expect Lr90 Rr-90
// expect L+ R+ true
// expect L0 R0 false
// expect L- R- L0 R0
// expect L- R+ L+ R- L0 R0
// expect Lr-204 Rr-204
// expect 100
// expect Lr229 Rr190
// expect Lr-216 Rr180
// expect start TRAVEL true
// expect stop 30 0
// expect start ROTATE true
// expect stop 0 180
