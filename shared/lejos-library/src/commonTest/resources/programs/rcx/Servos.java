import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.Servo;

public class Servos {
    public static void main(String[] arguments) {
        Servo servo = new Servo(Sensor.S3, Motor.B); // rom: 0x1946 0x1002
        servo.rotateTo(0); // rom: 0x1a4e 0x2001 4 7
        servo.rotateTo(8); // rom: 0x1a4e 0x2001 4 7 | 0x1a4e 0x2001 2 7
        servo.rotateTo(-8); // rom: 0x1a4e 0x2001 2 7 | 0x1a4e 0x2001 1 7
        servo.stateChanged(Sensor.S3, 0, -7);
        servo.stateChanged(Sensor.S3, -7, -8); // rom: 0x1a4e 0x2001 3 7
        Servo loose = new Servo(Sensor.S1, Motor.A, 2); // rom: 0x1946 0x1000
        loose.rotateTo(1); // rom: 0x1a4e 0x2000 4 7 | 0x1a4e 0x2000 1 7
    }
}
