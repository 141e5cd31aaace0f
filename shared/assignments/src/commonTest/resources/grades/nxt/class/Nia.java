import lejos.nxt.*;

public class Nia {
    public static void main(String[] args) throws Exception {
        I2CPort port = SensorPort.S4;
        port.i2cEnable(I2CPort.LEGO_MODE);
        NXTMotor motor = new NXTMotor(MotorPort.A);
        byte[] bytes = new byte[100];
        for (int n = 0; ; n++) {
            port.i2cTransaction(n, bytes, n % 90, n % 200, bytes, n % 90, n % 200);
            motor.setPower(n * n);
            motor.backward();
            LCD.bitBlt(bytes, n, -n, n, n, n, -n, n, n, n);
        }
    }
}
