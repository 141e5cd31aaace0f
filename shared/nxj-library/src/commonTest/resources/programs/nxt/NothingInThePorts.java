import lejos.nxt.Battery;
import lejos.nxt.NXT;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;
import lejos.nxt.UltrasonicSensor;
import lejos.nxt.comm.Bluetooth;
import lejos.nxt.comm.NXTConnection;
import lejos.nxt.comm.RConsole;

/** What programs see of a brick with nothing around it. */
public class NothingInThePorts {
    public static void main(String[] arguments) {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S2);
        System.out.println(sonar.getDistance() + " " + sonar.getRange()); // expect 255 255.0
        System.out.println(new TouchSensor(SensorPort.S1).isPressed()); // expect false
        System.out.println(SensorPort.S4.readRawValue()); // expect -1
        System.out.println(SensorPort.S3.getMode() + " " + SensorPort.PORTS.length); // expect 0 4
        try {
            SensorPort.S1.setType(99);
        } catch (IllegalArgumentException wrong) {
            System.out.println("no such type"); // expect no such type
        }
        int millivolts = Battery.getVoltageMilliVolt();
        System.out.println(millivolts > 6000 && millivolts < 10000); // expect true
        System.out.println(Math.round(Battery.getVoltage() * 1000) == millivolts); // expect true
        System.out.println(NXT.getFirmwareMajorVersion() + " " + NXT.getFirmwareMinorVersion()); // expect 0 9
        System.out.println(Bluetooth.getKnownDevice("nobody") == null); // expect true
        System.out.println(Bluetooth.connect("nobody", NXTConnection.PACKET) == null); // expect true
        System.out.println(Bluetooth.waitForConnection(50, NXTConnection.PACKET) == null); // expect true
        RConsole.openUSB(1000);
        System.out.println(RConsole.isOpen()); // expect true
        RConsole.close();
    }
}
