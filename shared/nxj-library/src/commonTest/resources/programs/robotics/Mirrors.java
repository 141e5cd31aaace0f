import lejos.robotics.EncoderMotor;
import lejos.robotics.MirrorMotor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/** Motors turned round; as in leJOS NXJ, a listener of one is told of the end of a move as of a beginning. */
public class Mirrors {
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
        Wheel wheel = new Wheel("W");
        RegulatedMotor mirror = MirrorMotor.invertMotor(wheel);
        mirror.addListener(new RegulatedMotorListener() {
            public void rotationStarted(RegulatedMotor motor, int count, boolean stalled, long time) {
                System.out.println("start " + count);
            }

            public void rotationStopped(RegulatedMotor motor, int count, boolean stalled, long time) {
                System.out.println("stop " + count);
            }
        });
        mirror.forward();
        mirror.backward();
        mirror.rotate(90);
        System.out.println(told());
        System.out.println(wheel.getTachoCount() + " " + mirror.getTachoCount());
        mirror.rotateTo(100);
        System.out.println(told() + " " + mirror.getTachoCount());
        mirror.setSpeed(200);
        System.out.println(wheel.getSpeed() + " " + mirror.getSpeed());
        System.out.println(MirrorMotor.invertMotor(mirror) == wheel);
        mirror.stop();
        mirror.flt();
        System.out.println(told());
        Engine engine = new Engine();
        EncoderMotor turned = MirrorMotor.invertMotor(engine);
        turned.setPower(30);
        turned.forward();
        System.out.println(engine.power + " " + engine.count + " " + turned.getTachoCount() + " " + turned.isMoving());
        System.out.println(MirrorMotor.invertMotor(turned) == engine);
    }

    /** A motor without regulation. */
    static class Engine implements EncoderMotor {
        int power;
        int count;

        public void setPower(int newPower) {
            power = newPower;
        }

        public int getPower() {
            return power;
        }

        public void forward() {
            count++;
        }

        public void backward() {
            count--;
        }

        public void stop() {
        }

        public void flt() {
        }

        public boolean isMoving() {
            return power != 0;
        }

        public int getTachoCount() {
            return count;
        }

        public void resetTachoCount() {
            count = 0;
        }
    }
}

// It prints:
// expect start 0
// expect start 0
// expect start 0
// expect start 90
// expect W- W+ Wr-90
// expect -90 90
// expect start 90
// expect start 100
// expect Wr-10 100
// expect 200 200
// expect true
// expect W0 W~
// expect 30 -1 1 true
// expect true
