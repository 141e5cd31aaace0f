import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.rcxcomm.remotecontrol.RemoteControlAdapter;
import josx.rcxcomm.remotecontrol.RemoteControlSensor;

public class RemoteControl extends RemoteControlAdapter {
    public void message2Pressed() {
        LCD.showNumber(2); // shows: 2
    }

    public void motorUpPressed(Motor motor) {
        LCD.showNumber(motor.getId()); // shows: 67
    }

    public void motorDownPressed(Motor motor) {
        LCD.showNumber(motor.getId() + 100); // shows: 165
    }

    public void program5Pressed() {
        LCD.showNumber(5); // shows: 5
    }

    public void stopPressed() {
        LCD.showNumber(0); // shows: 0
    }

    public void soundPressed() {
        LCD.showNumber(9); // shows: 9
    }

    static void press(RemoteControlSensor sensor, int buttons) {
        byte[] packet = {(byte) 0xD2, (byte) (buttons >> 8), (byte) buttons};
        sensor.packetAvailable(packet, 3);
    }

    public static void main(String[] arguments) {
        RemoteControlSensor sensor = new RemoteControlSensor();
        RemoteControl listener = new RemoteControl();
        sensor.addRemoteControlListener(listener);
        press(sensor, 0x0002);
        press(sensor, 0x0020);
        press(sensor, 0x0040);
        press(sensor, 0x2000);
        press(sensor, 0x4000);
        press(sensor, 0x8000);
        press(sensor, 0x0000);
        press(sensor, 0x0001);
        sensor.removeRemoteControlListener(listener);
        press(sensor, 0x0002);
    }
}
