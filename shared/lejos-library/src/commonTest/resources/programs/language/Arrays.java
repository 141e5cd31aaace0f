import josx.platform.rcx.LCD;

public class Arrays {
    public static void main(String[] arguments) {
        int[] numbers = new int[5];
        LCD.showNumber(numbers.length); // shows: 5
        LCD.showNumber(numbers[4]); // shows: 0
        for (int index = 0; index < numbers.length; index++) numbers[index] = index * index;
        LCD.showNumber(numbers[3]); // shows: 9
        numbers[3] += 10;
        numbers[3]++;
        LCD.showNumber(numbers[3]); // shows: 20
        int[] same = numbers;
        same[0] = 77;
        LCD.showNumber(numbers[0]); // shows: 77
        int[] listed = {4, 5, 6};
        LCD.showNumber(listed[0] + listed[1] + listed[2]); // shows: 15
        boolean[] answers = new boolean[2];
        answers[1] = true;
        LCD.showNumber(answers[0] || !answers[1] ? 1 : 0); // shows: 0
        String[] words = {"one", null};
        LCD.showNumber(words[0].length()); // shows: 3
        LCD.showNumber(words[1] == null ? 1 : 0); // shows: 1
    }
}
