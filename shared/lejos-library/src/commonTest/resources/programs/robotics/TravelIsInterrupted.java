import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.robotics.TimingNavigator;

public class TravelIsInterrupted extends Thread {
    static final TimingNavigator robot = new TimingNavigator(Motor.C, Motor.A, 5f, 3.6f);

    public void run() {
        robot.travel(100);
    }

    public static void main(String[] arguments) throws InterruptedException {
        new TravelIsInterrupted().start();
        Thread.sleep(1000);
        robot.stop();
        LCD.showNumber(Math.round(robot.getX())); // shows: 20
    }
}
// ends at 1000
