import lejos.nxt.MotorPort;
import lejos.nxt.NXTMotor;

public class UnregulatedMotors {
    public static void main(String[] arguments) throws InterruptedException {
        NXTMotor motor = new NXTMotor(MotorPort.B);
        motor.setPower(50); // calls controlMotorById 1 0 0
        motor.forward(); // calls controlMotorById 1 50 1
        Thread.sleep(500);
        motor.setPower(80); // calls controlMotorById 1 80 1
        motor.backward(); // calls controlMotorById 1 -80 1
        motor.stop(); // calls controlMotorById 1 0 1
        System.out.println(motor.isMoving() + " " + motor.getPower()); // screen false 80
        motor.flt(); // calls controlMotorById 1 0 0
        motor.resetTachoCount(); // calls resetTachoCountById 1
        System.out.println(motor.getTachoCount()); // screen 0
        MotorPort.A.controlMotor(30, 1); // calls controlMotorById 0 30 0
        MotorPort.A.controlMotor(30, 2); // calls controlMotorById 0 -30 0
        MotorPort.A.setPWMMode(MotorPort.PWM_BRAKE);
        MotorPort.A.controlMotor(30, MotorPort.FORWARD); // calls controlMotorById 0 30 1
        MotorPort.A.controlMotor(0, MotorPort.FLOAT); // calls controlMotorById 0 0 0
        System.out.println(MotorPort.getInstance(2) == MotorPort.C); // screen true
        Thread.sleep(300);
    }
}
