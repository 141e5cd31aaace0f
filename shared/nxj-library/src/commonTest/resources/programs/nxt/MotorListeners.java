import lejos.nxt.Motor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/** Listeners are told before whoever waits goes on. */
public class MotorListeners {
    static int started;
    static int stopped;

    public static void main(String[] arguments) throws InterruptedException {
        RegulatedMotorListener listener = new RegulatedMotorListener() {
            public void rotationStarted(RegulatedMotor motor, int count, boolean stalled, long time) {
                started++;
            }

            public void rotationStopped(RegulatedMotor motor, int count, boolean stalled, long time) {
                stopped++;
            }
        };
        Motor.A.addListener(listener);
        Motor.C.addListener(listener);
        Motor.A.rotate(50);
        System.out.println(started + " " + stopped); // expect 1 1
        Motor.A.rotate(50, true);
        Motor.C.rotate(80, true);
        System.out.println(started + " " + stopped); // expect 3 1
        Motor.A.waitComplete();
        Motor.C.waitComplete();
        System.out.println(started + " " + stopped); // expect 3 3
        Motor.A.forward();
        Thread.sleep(100);
        Motor.A.setSpeed(500);
        Motor.A.stop();
        System.out.println(started + " " + stopped); // expect 4 4
        System.out.println(Motor.A.removeListener() == listener); // expect true
        Motor.A.rotate(20);
        System.out.println(started + " " + stopped + " " + Motor.A.removeListener()); // expect 4 4 null
        Thread.sleep(20);
    }
}
