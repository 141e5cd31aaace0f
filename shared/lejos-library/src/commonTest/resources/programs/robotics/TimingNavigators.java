import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.robotics.Navigator;
import josx.robotics.TimingNavigator;

public class TimingNavigators {
    public static void main(String[] arguments) throws InterruptedException {
        TimingNavigator robot = new TimingNavigator(Motor.C, Motor.A, 5f, 3.6f);
        robot.travel(20); // rom: 0x1a4e 0x2002 1 3 | 0x1a4e 0x2000 1 3 | 0x1a4e 0x2000 3 7 | 0x1a4e 0x2002 3 7
        robot.rotate(90); // rom: 0x1a4e 0x2002 1 3 | 0x1a4e 0x2000 2 3 | 0x1a4e 0x2002 3 7 | 0x1a4e 0x2000 3 7
        robot.rotate(-30); // rom: 0x1a4e 0x2000 1 3 | 0x1a4e 0x2002 2 3 | 0x1a4e 0x2002 3 7 | 0x1a4e 0x2000 3 7
        if (robot.getAngle() != 60) throw new Error("angle");
        robot.gotoAngle(350); // rom: 0x1a4e 0x2000 1 3 | 0x1a4e 0x2002 2 3 | 0x1a4e 0x2002 3 7 | 0x1a4e 0x2000 3 7
        if (robot.getAngle() != 350) throw new Error("angle");
        if (Math.round(robot.getX()) != 20 || Math.round(robot.getY()) != 0) throw new Error("place");
        robot.backward(); // rom: 0x1a4e 0x2002 2 3 | 0x1a4e 0x2000 2 3
        robot.stop(); // rom: 0x1a4e 0x2000 3 7 | 0x1a4e 0x2002 3 7
        robot.forward(); // rom: 0x1a4e 0x2002 1 3 | 0x1a4e 0x2000 1 3
        robot.stop(); // rom: 0x1a4e 0x2000 3 7 | 0x1a4e 0x2002 3 7
        robot.setMomentumDelay((short) 100);
        Navigator any = robot;
        any.rotate(0); // rom: 0x1a4e 0x2002 3 7 | 0x1a4e 0x2000 3 7
    }
}
// ends at 3000
