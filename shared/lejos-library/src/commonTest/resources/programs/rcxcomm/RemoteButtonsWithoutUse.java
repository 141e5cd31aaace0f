import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.rcxcomm.remotecontrol.RemoteControlAdapter;

public class RemoteButtonsWithoutUse {
    public static void main(String[] arguments) {
        RemoteControlAdapter adapter = new RemoteControlAdapter();
        adapter.message1Pressed();
        adapter.message2Pressed();
        adapter.message3Pressed();
        adapter.program1Pressed();
        adapter.program2Pressed();
        adapter.program3Pressed();
        adapter.program4Pressed();
        adapter.program5Pressed();
        adapter.motorDownPressed(Motor.A);
        adapter.motorUpPressed(Motor.A);
        adapter.soundPressed();
        adapter.stopPressed();
        LCD.showNumber(1); // rom: 0x1ff2 0x301f 1 0x3002 | 0x27c8
    }
}
