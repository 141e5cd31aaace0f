import lejos.nxt.Motor;

/** What a regulated motor does at its defaults, and with other speeds. */
public class RegulatedMotors {
    static String near(int value, int wanted) {
        return Math.abs(value - wanted) <= 2 ? "" + wanted : "not " + wanted + " but " + value;
    }

    public static void main(String[] arguments) throws InterruptedException {
        System.out.println(Motor.A.getSpeed() + " " + Motor.A.getAcceleration()); // expect 360 6000
        System.out.println(Motor.A.isMoving() + " " + Motor.A.isStalled()); // expect false false
        Motor.A.rotate(90);
        System.out.println(near(Motor.A.getTachoCount(), 90)); // expect 90
        Motor.A.rotate(-30);
        System.out.println(near(Motor.A.getTachoCount(), 60) + " " + Motor.A.getPosition()); // expect 60 60
        Motor.A.rotateTo(-45);
        System.out.println(near(Motor.A.getTachoCount(), -45) + " " + Motor.A.getLimitAngle()); // expect -45 -45
        Motor.A.setSpeed(100);
        long before = System.currentTimeMillis();
        Motor.A.rotate(100);
        int time = (int) (System.currentTimeMillis() - before);
        System.out.println(time > 1000 && time < 1600); // expect true
        before = System.currentTimeMillis();
        Motor.A.rotate(100, true);
        System.out.println(System.currentTimeMillis() - before < 20); // expect true
        System.out.println(Motor.A.isMoving() + " " + Motor.A.getLimitAngle()); // expect true 155
        Motor.A.waitComplete();
        System.out.println(near(Motor.A.getTachoCount(), 155) + " " + Motor.A.isMoving()); // expect 155 false
        Motor.A.resetTachoCount();
        System.out.println(near(Motor.A.getTachoCount(), 0)); // expect 0
        Motor.A.rotateTo(10);
        System.out.println(near(Motor.A.getTachoCount(), 10)); // expect 10
        System.out.println(Motor.A == Motor.getInstance(0)); // expect true
        System.out.println(Motor.A.getMaxSpeed() > 700); // expect true
    }
}
