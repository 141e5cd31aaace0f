import lejos.util.Delay;
import lejos.util.PIDController;
import lejos.util.Stopwatch;
import lejos.util.Timer;
import lejos.util.TimerListener;

public class Controllers {
    static int times;

    public static void main(String[] arguments) {
        PIDController controller = new PIDController(50, 0);
        controller.setPIDParam(PIDController.PID_KP, 2);
        System.out.println(controller.doPID(40)); // expect 0
        Delay.msDelay(3);
        System.out.println(controller.doPID(50)); // expect 0
        Delay.msDelay(3);
        System.out.println(controller.doPID(40)); // expect 20
        Delay.msDelay(3);
        System.out.println(controller.doPID(55)); // expect -10
        controller.setPIDParam(PIDController.PID_LIMITHIGH, 15);
        controller.setPIDParam(PIDController.PID_LIMITLOW, -15);
        Delay.msDelay(3);
        System.out.println(controller.doPID(0)); // expect 15
        Delay.msDelay(3);
        System.out.println(controller.doPID(100)); // expect -15
        controller.setPIDParam(PIDController.PID_DEADBAND, 5);
        Delay.msDelay(3);
        System.out.println(controller.doPID(47)); // expect 0
        System.out.println(controller.getPIDParam(PIDController.PID_SETPOINT) + " " + controller.getPIDParam(PIDController.PID_KP)); // expect 50.0 2.0
        Stopwatch watch = new Stopwatch();
        Delay.msDelay(30);
        int elapsed = watch.elapsed();
        System.out.println(elapsed >= 30 && elapsed < 500); // expect true
        watch.reset();
        System.out.println(watch.elapsed() < 20); // expect true
        Delay.msDelay(-5);
        final Timer[] timer = new Timer[1];
        timer[0] = new Timer(10, new TimerListener() {
            public void timedOut() {
                times++;
                if (times == 3) timer[0].stop();
            }
        });
        System.out.println(timer[0].getDelay()); // expect 10
        timer[0].start();
        while (times < 3) Delay.msDelay(5);
        Delay.msDelay(40);
        System.out.println(times); // expect 3
    }
}
