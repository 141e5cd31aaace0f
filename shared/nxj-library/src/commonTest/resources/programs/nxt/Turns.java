import lejos.nxt.Motor;

/** A motor turns exactly so far, and tells where it is. */
public class Turns {
    public static void main(String[] args) throws Exception {
        Motor.A.setSpeed(360);
        Motor.A.rotate(360);
        int there = Motor.A.getTachoCount();
        System.out.println(there >= 359 && there <= 361); // screen true
        Motor.B.forward();
        Thread.sleep(500);
        System.out.println(Motor.B.isMoving() + " " + (Motor.B.getTachoCount() > 50)); // screen true true
        Motor.B.stop();
        Motor.A.rotateTo(-90, true);
        while (Motor.A.isMoving()) Thread.yield();
        System.out.println(Math.abs(Motor.A.getTachoCount() + 90) < 2); // screen true
        Thread.sleep(300);
    }
}
// expect true
// expect true true
// expect true
