import josx.platform.rcx.LCD;
import josx.platform.rcx.Memory;
import josx.platform.rcx.ProximitySensor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.Serial;

public class ProximityPulses {
    static boolean isRangeLong() {
        return (Memory.readByte(0xFFB7) & 1) == 0;
    }

    public static void main(String[] arguments) throws InterruptedException {
        LCD.showNumber(isRangeLong() ? 1 : 0); // shows: 0
        new ProximitySensor(Sensor.S2);
        LCD.showNumber(isRangeLong() ? 1 : 0); // shows: 1
        int end = (int) System.currentTimeMillis() + 370;
        int pulses = 0;
        boolean wasSending = false;
        while ((int) System.currentTimeMillis() < end) {
            boolean isSending = Serial.isSending();
            if (isSending && !wasSending) pulses++;
            wasSending = isSending;
            Thread.sleep(5);
        }
        LCD.showNumber(pulses); // shows: 4
    }
}
