import lejos.nxt.*;

public class Nia {
    public static void main(String[] args) throws Exception {
        I2CPort port = SensorPort.S4;
        port.i2cEnable(I2CPort.LEGO_MODE);
        byte[] bytes = new byte[100];
        for (int n = 0; ; n++) {
            port.i2cTransaction(n, bytes, n, n % 200, bytes, -n, n % 200);
            Motor.A.setPower(n * n);
            LCD.bitBlt(bytes, n, -n, n, n, n, -n, n, n, n);
        }
    }
}
