import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.robotics.RotationNavigator;

public class RotationNavigators {
    public static void main(String[] arguments) {
        RotationNavigator robot = new RotationNavigator(5f, 12f, 1f); // rom: 0x1946 0x1000 | 0x1946 0x1002
        robot.rotate(0); // rom: 0x1a4e 0x2002 3 7 | 0x1a4e 0x2000 3 7
        robot.travel(0);
        robot.stop();
        if (robot.getX() != 0 || robot.getY() != 0 || robot.getAngle() != 0) throw new Error("place");
        new RotationNavigator(5f, 12f, 1f, Motor.A, Motor.B, Sensor.S2, Sensor.S3); // rom: 0x1946 0x1001 | 0x1946 0x1002
        robot.gotoAngle(0); // rom: 0x1a4e 0x2002 3 7 | 0x1a4e 0x2000 3 7
        System.exit(0);
    }
}
