import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.rcxcomm.remotecontrol.RemoteControlAdapter;
import josx.rcxcomm.remotecontrol.RemoteControlListener;
import josx.rcxcomm.remotecontrol.RemoteControlSensor;

public class AllRemoteButtons implements RemoteControlListener {
    static void show(int number) {
        LCD.showNumber(number); // shows: 1 2 3 65 66 67 165 166 167 11 12 13 14 15 20 30
    }

    public void message1Pressed() {
        show(1);
    }

    public void message2Pressed() {
        show(2);
    }

    public void message3Pressed() {
        show(3);
    }

    public void program1Pressed() {
        show(11);
    }

    public void program2Pressed() {
        show(12);
    }

    public void program3Pressed() {
        show(13);
    }

    public void program4Pressed() {
        show(14);
    }

    public void program5Pressed() {
        show(15);
    }

    public void motorDownPressed(Motor motor) {
        show(100 + motor.getId());
    }

    public void motorUpPressed(Motor motor) {
        show(motor.getId());
    }

    public void soundPressed() {
        show(30);
    }

    public void stopPressed() {
        show(20);
    }

    public static void main(String[] arguments) {
        RemoteControlSensor sensor = new RemoteControlSensor();
        sensor.addRemoteControlListener(new RemoteControlAdapter());
        sensor.addRemoteControlListener(new AllRemoteButtons());
        byte[] packet = {(byte) 0xD2, 0, 0};
        int bits = 1;
        for (int button = 0; button < 16; button++) {
            packet[1] = (byte) (bits >> 8);
            packet[2] = (byte) bits;
            sensor.packetAvailable(packet, 3);
            bits <<= 1;
        }
    }
}
