public class LongNumbers {
    static long power(long base, int exponent) {
        long result = 1;
        for (int i = 0; i < exponent; i++) result *= base;
        return result;
    }

    public static void main(String[] arguments) {
        long large = 1234567890123L;
        System.out.println(large); // expect 1234567890123
        System.out.println(large * 1000); // expect 1234567890123000
        System.out.println(large * large); // expect -4353767495901316871
        System.out.println(large / 7 + " " + large % 7); // expect 176366841446 1
        System.out.println(-large / 7 + " " + -large % 7); // expect -176366841446 -1
        System.out.println(Long.MIN_VALUE / -1); // expect -9223372036854775808
        System.out.println(Long.MAX_VALUE + 1); // expect -9223372036854775808
        System.out.println(large << 20); // expect 1294538259953614848
        System.out.println(large << 64); // expect 1234567890123
        System.out.println(-large >> 10); // expect -1205632706
        System.out.println(-large >>> 10); // expect 18014397303849278
        System.out.println((large & 0xFFFF) + " " + (large | 0xFFFF) + " " + (large ^ 0xFFFF) + " " + ~large);
        // expect 1227 1234567954431 1234567953204 -1234567890124
        System.out.println((int) large); // expect 1912276171
        System.out.println((short) large + " " + (byte) large + " " + (int) (char) large); // expect 1227 -53 1227
        System.out.println(power(3, 39)); // expect 4052555153018976267
        System.out.println(power(-7, 22)); // expect 3909821048582988049
        System.out.println(large > 1234567890122L); // expect true
        System.out.println(large == 1234567890123L ? "same" : "other"); // expect same
        long count = 0;
        for (long i = 4294967290L; i < 4294967300L; i++) count += i & 7;
        System.out.println(count); // expect 33
        long[] numbers = {1L, -2L, 3000000000L};
        numbers[1] += numbers[2]++;
        System.out.println(numbers[1] + " " + numbers[2]); // expect 2999999998 3000000001
        int shift = 3;
        shift += 5000000000L;
        System.out.println(shift); // expect 705032707
    }
}
