import lejos.nxt.Motor;
import lejos.nxt.NXTRegulatedMotor;
import lejos.util.Delay;

/** Three motors at a time, each in a thread of its own. */
public class TwoRobotsInOne {
    static class Turner extends Thread {
        private final NXTRegulatedMotor motor;
        private final int angle;

        Turner(NXTRegulatedMotor motor, int angle) {
            this.motor = motor;
            this.angle = angle;
        }

        @Override
        public void run() {
            for (int i = 0; i < 3; i++) {
                motor.rotate(angle);
                Delay.msDelay(10);
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Turner[] turners = {new Turner(Motor.A, 60), new Turner(Motor.B, -90), new Turner(Motor.C, 120)};
        for (Turner turner : turners) turner.start();
        for (Turner turner : turners) turner.join();
        System.out.println(Math.abs(Motor.A.getTachoCount() - 180) < 3); // expect true
        System.out.println(Math.abs(Motor.B.getTachoCount() + 270) < 3); // expect true
        System.out.println(Math.abs(Motor.C.getTachoCount() - 360) < 3); // expect true
    }
}
