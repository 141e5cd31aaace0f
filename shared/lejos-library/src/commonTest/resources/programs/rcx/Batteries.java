import josx.platform.rcx.Battery;
import josx.platform.rcx.LCD;

public class Batteries {
    public static void main(String[] arguments) {
        int raw = Battery.getVoltageInternal(); // rom: 0x29f2 0x4001 ?
        int millivolts = Battery.getVoltageMilliVolt(); // rom: 0x29f2 0x4001 ?
        float volts = Battery.getVoltage(); // rom: 0x29f2 0x4001 ?
        if (millivolts == raw * 43988 / 1560 && volts * 1000 > millivolts - 2) LCD.clear(); // rom: 0x27ac
    }
}
