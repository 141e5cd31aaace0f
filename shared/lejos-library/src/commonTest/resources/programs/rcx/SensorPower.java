import josx.platform.rcx.Sensor;

public class SensorPower {
    public static void main(String[] arguments) {
        Sensor.S1.activate(); // rom: 0x1946 0x1000
        Sensor.S2.activate(); // rom: 0x1946 0x1001
        Sensor.S3.passivate(); // rom: 0x19c4 0x1002
        Sensor.S1.setTypeAndMode(1, 0x20);
        Sensor.S1.setPreviousValue(0);
    }
}
