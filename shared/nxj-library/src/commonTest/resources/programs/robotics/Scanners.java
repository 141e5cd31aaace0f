import lejos.robotics.FixedRangeScanner;
import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReadings;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.robotics.RotatingRangeScanner;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.RotateMoveController;

public class Scanners {
    /** A head that is at once where it should be. */
    static class Head implements RegulatedMotor {
        int angle;

        public void forward() { }

        public void backward() { }

        public void stop() { }

        public void stop(boolean immediateReturn) { }

        public void flt() { }

        public void flt(boolean immediateReturn) { }

        public void rotate(int by) {
            angle += by;
        }

        public void rotate(int by, boolean immediateReturn) {
            angle += by;
        }

        public void rotateTo(int to) {
            angle = to;
        }

        public void rotateTo(int to, boolean immediateReturn) {
            angle = to;
        }

        public int getLimitAngle() {
            return angle;
        }

        public void waitComplete() { }

        public int getTachoCount() {
            return angle;
        }

        public void resetTachoCount() {
            angle = 0;
        }

        public int getRotationSpeed() {
            return 0;
        }

        public void setSpeed(int speed) { }

        public int getSpeed() {
            return 360;
        }

        public float getMaxSpeed() {
            return 800;
        }

        public void setAcceleration(int acceleration) { }

        public int getAcceleration() {
            return 6000;
        }

        public boolean isMoving() {
            return false;
        }

        public boolean isStalled() {
            return false;
        }

        public void setStallThreshold(int error, int time) { }

        public void addListener(RegulatedMotorListener listener) { }

        public RegulatedMotorListener removeListener() {
            return null;
        }
    }

    public static void main(String[] arguments) {
        final Head head = new Head();
        RangeFinder finder = new RangeFinder() {
            public float getRange() {
                return head.angle == 90 ? 255 : 30 + Math.abs(head.angle);
            }

            public float[] getRanges() {
                return new float[] {getRange()};
            }
        };
        RotatingRangeScanner scanner = new RotatingRangeScanner(head, finder);
        scanner.setAngles(new float[] {-45, 0, 45, 90});
        RangeReadings readings = scanner.getRangeValues();
        System.out.println(readings.getNumReadings() + " " + readings.incomplete()); // expect 4 true
        for (int i = 0; i < 3; i++) System.out.println(readings.getAngle(i) + " " + readings.getRange(i)); // expect -45.0 77.0
        // expect 0.0 32.0
        // expect 45.0 77.0
        System.out.println(readings.getRange(45f) + " " + readings.getRange(3) + " " + (scanner.getRangeFinder() == finder)); // expect 77.0 -1.0 true
        System.out.println(head.angle); // expect 0
        scanner.setGearRatio(3);
        scanner.setAngles(new float[] {20.9f, 51});
        readings = scanner.getRangeValues();
        System.out.println(readings.getRange(0) + " " + readings.getRange(1)); // expect 92.0 -1.0
        final Turner turner = new Turner();
        FixedRangeScanner fixed = new FixedRangeScanner(turner, new RangeFinder() {
            public float getRange() {
                return turner.angle == 200 ? 180 : 50;
            }

            public float[] getRanges() {
                return null;
            }
        });
        fixed.setAngles(new float[] {90, -100, 200});
        readings = fixed.getRangeValues();
        System.out.println(turner.log); // expect 90.0 170.0 -60.0 160.0 
        System.out.println(readings.getRange(0) + " " + readings.getRange(2)); // expect 52.0 -1.0
    }

    /** A robot that turns at once. */
    static class Turner implements RotateMoveController {
        final StringBuilder log = new StringBuilder();
        double angle;

        public void rotate(double by) {
            angle += by;
            log.append(by).append(' ');
        }

        public void rotate(double by, boolean immediateReturn) {
            rotate(by);
        }

        public void setRotateSpeed(double speed) { }

        public double getRotateSpeed() {
            return 0;
        }

        public double getRotateMaxSpeed() {
            return 0;
        }

        public void forward() { }

        public void backward() { }

        public void stop() { }

        public boolean isMoving() {
            return false;
        }

        public void travel(double distance) { }

        public void travel(double distance, boolean immediateReturn) { }

        public void setTravelSpeed(double speed) { }

        public double getTravelSpeed() {
            return 0;
        }

        public double getMaxTravelSpeed() {
            return 0;
        }

        public Move getMovement() {
            return null;
        }

        public void addMoveListener(MoveListener listener) { }
    }
}
