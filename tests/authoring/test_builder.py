"""Every call and every refusal, case by case. A refused call changes nothing: ``refused`` looks at that in every case."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.authoring.answer import Answer
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.findings import MAX_DEPTH, MAX_NODES
from missiontree.authoring.tools import ToolBox
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.tree import Link, MissionTree
from tests.authoring.conftest import REUNITE, begun

ROOT = "reunite-mom-with-her-lost-child"


def tree_of(box: ToolBox) -> MissionTree:
    assert box.builder.tree is not None
    return box.builder.tree


def refused(box: ToolBox, function: str, /, **arguments: Any) -> Answer:
    before = box.builder.state
    answer = box.call(function, arguments)
    assert not answer.ok
    assert answer.reasons
    assert answer.data == {}
    assert box.builder.state is before
    return answer


def rule(answer: Answer) -> str:
    return answer.reasons[0].rule


def attach(parent: str = "Find", **changes: Any) -> dict[str, Any]:
    call = {
        "parentString": parent,
        "treeNames": ["SearchTree"],
        "treeArguments": [["Child"]],
        "LogicalConstraint": "AND",
    }
    return call | changes


def subtask(parent: str = "Find", name: str = "Look", gate: str = "AND") -> dict[str, Any]:
    return {"parentString": parent, "isPrimitive": False, "taskName": name, "LogicalConstraint": gate}


class TestInit:
    def test_the_objective_becomes_the_root(self, brief: MissionBrief) -> None:
        box = ToolBox(TreeBuilder(brief))
        answer = box.call("HierarchicalTree_init", {"objective": " Reunite\nmom  with her lost child"})
        assert answer.data["root"] == ROOT
        assert answer.data["open_leaves"] == [ROOT]
        assert tree_of(box).objective == " Reunite\nmom  with her lost child"

    def test_a_long_objective_is_kept_and_shown_short(self, brief: MissionBrief) -> None:
        """Models name the root by the objective, so that goes on working however long it is."""
        box, objective = ToolBox(TreeBuilder(brief)), "find mom " * 1_000
        answer = box.call("HierarchicalTree_init", {"objective": objective})
        assert len(answer.text) < 1_500
        assert tree_of(box).objective == objective
        assert box.call("CreateAndAddSubtask", subtask(parent=objective)).notices == ()

    def test_a_second_tree_is_refused(self, box: ToolBox) -> None:
        assert rule(refused(box, "HierarchicalTree_init", objective="Another")) == "duplicate"

    @pytest.mark.parametrize("objective", ["", " \n ", "a\x00b", "a\x1bb"])
    def test_an_objective_without_words_is_refused(self, brief: MissionBrief, objective: str) -> None:
        assert (
            rule(refused(ToolBox(TreeBuilder(brief)), "HierarchicalTree_init", objective=objective))
            == "malformed_arguments"
        )

    @pytest.mark.parametrize(
        ("name", "arguments"),
        [
            ("CreateAndAddSubtask", subtask()),
            ("attachMultiSubTrees", attach()),
            ("printTree", {}),
            ("plotTree", {}),
            ("checkTree", {}),
            ("introduceEntity", {"name": "x", "kind": "object"}),
            ("removeSubtask", {"subtask": "x"}),
            ("setLink", {"first": "a", "second": "b"}),
            ("dropLink", {"first": "a", "second": "b"}),
        ],
    )
    def test_nothing_else_comes_before_it(self, brief: MissionBrief, name: str, arguments: dict[str, Any]) -> None:
        assert rule(refused(ToolBox(TreeBuilder(brief)), name, **arguments)) == "no_tree"


class TestTasks:
    def test_a_single_child_is_accepted_and_reads_and(self, box: ToolBox) -> None:
        answer = box.call("CreateAndAddSubtask", subtask(gate="XOR"))
        assert answer.data["added"] == [{"id": "look", "label": "Look"}]
        assert tree_of(box).by_id["find"].gate == "and"

    def test_the_gate_of_a_single_child_is_kept_for_the_next(self, box: ToolBox) -> None:
        """XOR was said with the first child, so XOR it becomes with the second."""
        box.call("CreateAndAddSubtask", subtask(gate="XOR"))
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(name="Ask", gate="AND"))) == "gate_conflict"
        assert box.call("CreateAndAddSubtask", subtask(name="Ask", gate="xor")).ok
        assert tree_of(box).by_id["find"].gate == "xor"
        assert tree_of(box).by_id["find"].children == ("look", "ask")

    def test_a_later_call_with_the_other_gate_is_refused_with_the_way_out(self, box: ToolBox) -> None:
        answer = refused(box, "CreateAndAddSubtask", **subtask(parent=REUNITE, gate="XOR"))
        assert rule(answer) == "gate_conflict"
        assert "insert a task" in answer.reasons[0].hint

    def test_a_parent_whose_children_are_gone_may_have_any_gate(self, box: ToolBox) -> None:
        box.call("CreateAndAddSubtask", subtask(gate="AND"))
        box.call("removeSubtask", {"subtask": "look"})
        assert box.call("CreateAndAddSubtask", subtask(name="Ask", gate="XOR")).ok

    def test_primitive_is_taken_as_not_primitive_and_said_so(self, box: ToolBox) -> None:
        answer = box.call("CreateAndAddSubtask", subtask() | {"isPrimitive": True})
        assert [notice.rule for notice in answer.notices] == ["not_primitive"]
        assert tree_of(box).by_id["look"] in tree_of(box).open_leaves

    def test_new_nodes_stand_in_preorder_behind_what_the_parent_has(self, box: ToolBox) -> None:
        box.call("CreateAndAddSubtask", subtask(parent="Bring", name="Carry"))
        box.call("CreateAndAddSubtask", subtask(parent="Find", name="Look"))
        assert [node.id for node in tree_of(box).nodes] == [ROOT, "find", "look", "bring", "carry"]

    def test_equal_names_below_different_tasks_get_different_ids(self, box: ToolBox) -> None:
        box.call("CreateAndAddSubtask", subtask(parent="Find"))
        assert box.call("CreateAndAddSubtask", subtask(parent="Bring")).data["added"] == [
            {"id": "look-2", "label": "Look"}
        ]
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(parent="Look", name="Ask"))) == "ambiguous_name"

    def test_names_may_be_any_unicode(self, box: ToolBox) -> None:
        assert box.call("CreateAndAddSubtask", subtask(name="迷子を探す 🐈")).data["added"] == [
            {"id": "task", "label": "迷子を探す 🐈"}
        ]
        assert box.call("CreateAndAddSubtask", subtask(parent="迷子を探す 🐈", name="Später")).ok

    @pytest.mark.parametrize("name", ["", "   ", "a\nb", "a\u2028b", "x" * 301])
    def test_names_are_one_line_of_words(self, box: ToolBox, name: str) -> None:
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(name=name))) == "malformed_arguments"

    def test_the_same_name_twice_below_one_task_is_refused(self, box: ToolBox) -> None:
        box.call("CreateAndAddSubtask", subtask())
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(name="LOOK"))) == "duplicate"
        twice = {
            "parentString": "Bring",
            "isPrimitiveList": [False, False],
            "taskNameList": ["A", "a"],
            "LogicalConstraint": "AND",
        }
        assert rule(refused(box, "addMultiSubtasks", **twice)) == "duplicate"

    def test_lists_of_different_length_are_refused(self, box: ToolBox) -> None:
        lists = {
            "parentString": "Find",
            "isPrimitiveList": [False],
            "taskNameList": ["A", "B"],
            "LogicalConstraint": "AND",
        }
        assert rule(refused(box, "addMultiSubtasks", **lists)) == "malformed_arguments"
        none = lists | {"isPrimitiveList": [], "taskNameList": []}
        assert rule(refused(box, "addMultiSubtasks", **none)) == "malformed_arguments"

    def test_too_many_nodes_are_refused_whole(self, box: ToolBox) -> None:
        """Three nodes stand: root, Find, Bring. With 9,997 more there are 10,000, and not one more goes in."""
        names = [f"t{number}" for number in range(MAX_NODES - 2)]
        lists = {"parentString": "Find", "LogicalConstraint": "AND"}
        over = lists | {"isPrimitiveList": [False] * len(names), "taskNameList": names}
        assert rule(refused(box, "addMultiSubtasks", **over)) == "size"
        assert box.call(
            "addMultiSubtasks", lists | {"isPrimitiveList": [False] * 9997, "taskNameList": names[:9997]}
        ).ok
        assert len(tree_of(box).nodes) == MAX_NODES

    def test_too_many_levels_are_refused(self, box: ToolBox) -> None:
        """The root stands on level 1 and Find on level 2, so 62 more go below it."""
        parent = "find"
        for level in range(3, MAX_DEPTH + 1):
            answer = box.call("CreateAndAddSubtask", subtask(parent=parent, name=f"level {level}"))
            assert answer.ok
            parent = answer.data["added"][0]["id"]
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(parent=parent))) == "size"


class TestParents:
    def test_an_exact_name_or_id_is_accepted_without_a_notice(self, box: ToolBox) -> None:
        assert box.call("CreateAndAddSubtask", subtask(parent="Find")).notices == ()
        assert box.call("CreateAndAddSubtask", subtask(parent="find", name="Ask")).notices == ()

    @pytest.mark.parametrize("name", ["FIND", "the find", "Find!", "  find "])
    def test_a_name_up_to_case_articles_and_punctuation_is_accepted_with_a_notice(
        self, box: ToolBox, name: str
    ) -> None:
        answer = box.call("CreateAndAddSubtask", subtask(parent=name))
        assert answer.data["parent"] == "find"
        assert [notice.rule for notice in answer.notices] == ["parent_matched"]

    def test_the_clear_nearest_match_is_accepted_with_a_notice(self, box: ToolBox) -> None:
        answer = box.call("CreateAndAddSubtask", subtask(parent="Reunite mom and the lost chidl"))
        assert answer.data["parent"] == ROOT
        assert [notice.rule for notice in answer.notices] == ["parent_matched"]

    def test_two_near_matches_are_none(self, box: ToolBox) -> None:
        for name in ("Search house", "Search and house"):
            box.call("CreateAndAddSubtask", subtask(name=name))
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(parent="Search with house"))) == "ambiguous_name"

    @pytest.mark.parametrize("name", ["Fnd", "F\u0456nd", "", "Fetch", "Find Bring", "\ud83d\ude00", "x" * 10_000])
    def test_anything_else_is_refused_with_what_there_is(self, box: ToolBox, name: str) -> None:
        """The second name has a Cyrillic letter that looks like an i."""
        answer = refused(box, "CreateAndAddSubtask", **subtask(parent=name))
        assert rule(answer) == "unknown_parent"
        assert "find, bring" in answer.reasons[0].hint
        assert len(answer.text) < 1_000

    def test_nothing_goes_below_a_routine(self, box: ToolBox) -> None:
        box.call("attachMultiSubTrees", attach())
        assert rule(refused(box, "CreateAndAddSubtask", **subtask(parent="Search(Child)"))) == "parent_is_routine"


class TestRoutines:
    def test_a_routine_is_attached_and_its_offers_told(self, box: ToolBox) -> None:
        answer = box.call("attachMultiSubTrees", attach())
        # Table I: Search is what the Tele-Robot (1.0) and the Transportation Robot (0.3) can do.
        assert answer.data["offers"] == [
            {"id": "search-child", "can_be_done_by": ["tele_robot", "transportation_robot"]}
        ]
        assert answer.data["open_leaves"] == ["bring"]
        node = tree_of(box).by_id["search-child"]
        assert (node.routine, dict(node.arguments), node.resources) == ("Search", {"agent": "child"}, None)

    @pytest.mark.parametrize("name", ["Search", "SearchTree"])
    def test_both_spellings_of_a_routine_are_accepted(self, box: ToolBox, name: str) -> None:
        assert box.call("attachMultiSubTrees", attach(treeNames=[name])).ok

    @pytest.mark.parametrize(
        "given",
        [
            ["Child", "Mom", ["tele_robot", "Social Robot"]],
            {"location": "mom", "agent": "CHILD", "resources": ["tele_robot", "social robot", "social_robot"]},
        ],
    )
    def test_resources_come_last_or_by_name(self, box: ToolBox, given: Any) -> None:
        assert box.call("attachMultiSubTrees", attach(treeNames=["TransportTree"], treeArguments=[given])).ok
        node = tree_of(box).by_id["transport-child-mom"] if isinstance(given, list) else tree_of(box).nodes[2]
        assert dict(node.arguments) == {"agent": tree_of(box).entities[0].id, "location": tree_of(box).entities[1].id}
        assert node.resources == ("tele_robot", "social_robot")

    @pytest.mark.parametrize("name", ["Serch", "searchtree", "SearchTreeTree", "Fly", "", "S\u0435arch"])
    def test_a_routine_is_never_guessed(self, box: ToolBox, name: str) -> None:
        answer = refused(box, "attachMultiSubTrees", **attach(treeNames=[name]))
        assert rule(answer) == "unknown_routine"
        assert "SearchTree" in answer.reasons[0].hint

    @pytest.mark.parametrize(
        ("given", "said"),
        [
            ("Child", "a text where arguments are expected"),
            (None, "null where arguments"),
            (7, "a number where arguments"),
            ([], "has 0 entries"),
            (["Child", "Mom"], "resources is a text"),
            (["Child", ["tele_robot"], "Mom"], "has 3 entries"),
            ([7], "agent is a number"),
            ([None], "agent is null"),
            ([["Child"]], "agent is a list"),
            ({}, "lacks Search's argument 'agent'"),
            ({"agnet": "Child"}, "no argument 'agnet'"),
            ({"agent": "Child", "location": "Mom"}, "no argument 'location'"),
            (["Child", []], "allows no robot"),
            (["Child", [1]], "resources is a list where a list of robot types"),
        ],
    )
    def test_arguments_of_another_shape_are_refused(self, box: ToolBox, given: Any, said: str) -> None:
        answer = refused(box, "attachMultiSubTrees", **attach(treeArguments=[given]))
        assert rule(answer) == "malformed_arguments"
        assert said in answer.reasons[0].message

    def test_names_and_arguments_go_together(self, box: ToolBox) -> None:
        assert (
            rule(refused(box, "attachMultiSubTrees", **attach(treeArguments=[["Child"], ["Mom"]])))
            == "malformed_arguments"
        )

    def test_a_robot_is_never_guessed(self, box: ToolBox) -> None:
        answer = refused(box, "attachMultiSubTrees", **attach(treeArguments=[["Child", ["tele_robots"]]]))
        assert rule(answer) == "unknown_robot"
        assert "'tele_robot'" in answer.reasons[0].hint

    def test_nobody_able_is_said_with_the_reason_of_each_type(self, box: ToolBox) -> None:
        """The Mobile Scooter lacks search, and nobody else is allowed."""
        answer = refused(box, "attachMultiSubTrees", **attach(treeArguments=[["Child", ["mobile_scooter"]]]))
        assert rule(answer) == "no_robot_able"
        by_type = {reason.robot: reason.rule for reason in answer.reasons[1:]}
        assert by_type["mobile_scooter"] == "capability_missing"
        assert by_type["tele_robot"] == "resource_excluded"

    def test_one_bad_routine_refuses_the_whole_call(self, box: ToolBox) -> None:
        call = attach(treeNames=["SearchTree", "FlyTree"], treeArguments=[["Child"], ["Mom"]])
        refused(box, "attachMultiSubTrees", **call)
        assert tree_of(box).entities == (), "Child was not introduced either"

    def test_the_same_routine_twice_below_one_task_is_refused(self, box: ToolBox) -> None:
        box.call("attachMultiSubTrees", attach())
        again = attach(treeNames=["Search"], treeArguments=[{"agent": "child"}])
        assert rule(refused(box, "attachMultiSubTrees", **again)) == "duplicate"
        assert box.call("attachMultiSubTrees", attach(treeArguments=[["Child", ["tele_robot"]]])).ok, "others may do it"

    def test_kinds_are_kept(self, scenic_box: ToolBox) -> None:
        """Nobody can follow a place: Follow takes person, animal or object."""
        call = attach(treeNames=["FollowTree"], treeArguments=[["North Gate"]])
        answer = refused(scenic_box, "attachMultiSubTrees", **call)
        assert rule(answer) == "wrong_kind"
        assert (answer.reasons[0].found, answer.reasons[0].needed) == ("place", "person, animal, object")

    def test_kinds_can_be_switched_off(self, scenic: MissionBrief) -> None:
        lax = MissionBrief(
            text=scenic.text, fleet=scenic.fleet, routines=scenic.routines, scene=scenic.scene, check_kinds=False
        )
        assert begun(lax).call("attachMultiSubTrees", attach(treeNames=["Follow"], treeArguments=[["North Gate"]])).ok


class TestEntities:
    @pytest.mark.parametrize("name", ["child", "Tim", "TIM", "the boy", "JÜNGSTER", "Ju\u0308ngster"])
    def test_the_scene_is_spoken_of_by_id_label_or_alias(self, scenic_box: ToolBox, name: str) -> None:
        assert scenic_box.call("attachMultiSubTrees", attach(treeArguments=[[name]])).ok
        assert tree_of(scenic_box).by_id["search-tim"].arguments["agent"] == "child"

    @pytest.mark.parametrize("name", ["Child!", "Tom", "T\u0456m", "boy", "lost", ""])
    def test_an_entity_is_never_guessed(self, scenic_box: ToolBox, name: str) -> None:
        """With a scene, not even a word of the mission is taken for an entity: it may be called otherwise there."""
        answer = refused(scenic_box, "attachMultiSubTrees", **attach(treeArguments=[[name]]))
        assert rule(answer) == "unknown_entity"
        assert "introduceEntity" in answer.reasons[0].hint

    def test_a_name_that_two_share_is_refused_with_their_ids(self, scenic_box: ToolBox) -> None:
        answer = refused(scenic_box, "attachMultiSubTrees", **attach(treeArguments=[["dog"]]))
        assert rule(answer) == "ambiguous_name"
        assert "dog_1, dog_2" in answer.reasons[0].message
        assert scenic_box.call("attachMultiSubTrees", attach(treeArguments=[["dog_2"]])).ok

    def test_without_a_scene_words_of_the_mission_become_entities_and_that_is_said(self, box: ToolBox) -> None:
        answer = box.call("attachMultiSubTrees", attach())
        assert tree_of(box).entities == (Entity(id="child", kind="person", label="Child"),)
        (assumption,) = answer.notices
        assert (assumption.severity, assumption.rule, assumption.node) == ("assumption", "entity_introduced", "child")
        assert "person" in assumption.message

    def test_without_a_scene_other_words_are_refused(self, box: ToolBox) -> None:
        """ "chil" is part of a word of the mission, and no word."""
        for name in ("chil", "grandma", "her mom"):
            assert rule(refused(box, "attachMultiSubTrees", **attach(treeArguments=[[name]]))) == "unknown_entity"

    def test_a_word_of_no_known_kind_is_taken_for_an_object(self, fleet: Fleet, brief: MissionBrief) -> None:
        box = begun(MissionBrief(text="Find the gizmo", fleet=fleet, routines=brief.routines))
        answer = box.call("attachMultiSubTrees", attach(treeArguments=[["gizmo"]]))
        assert tree_of(box).entities[0].kind == "object"
        assert "not in the list of nouns" in answer.notices[0].message

    def test_an_entity_is_introduced_with_its_kind(self, scenic_box: ToolBox) -> None:
        answer = scenic_box.call("introduceEntity", {"name": "Old Dog", "kind": "dog"})
        assert answer.data["entity"] == "old-dog"
        assert [notice.severity for notice in answer.notices] == ["assumption"]
        assert scenic_box.call("attachMultiSubTrees", attach(treeArguments=[["old dog"]])).ok

    def test_what_is_known_is_not_introduced_again(self, scenic_box: ToolBox) -> None:
        assert rule(refused(scenic_box, "introduceEntity", name="tim", kind="person")) == "duplicate"

    @pytest.mark.parametrize("kind", ["Person", "robot", "cat", ""])
    def test_a_kind_is_never_guessed(self, scenic_box: ToolBox, kind: str) -> None:
        answer = refused(scenic_box, "introduceEntity", name="Anna", kind=kind)
        assert rule(answer) == "unknown_kind"
        assert "person, animal, object, place, dog" in answer.reasons[0].hint

    @pytest.mark.parametrize("name", ["", " ", "a\nb"])
    def test_an_entity_has_a_name(self, box: ToolBox, name: str) -> None:
        assert rule(refused(box, "introduceEntity", name=name, kind="person")) == "malformed_arguments"


class TestLinks:
    def test_pairs_name_nodes_by_id_name_index_or_call(self, box: ToolBox) -> None:
        call = attach(
            treeNames=["SearchTree", "FollowTree", "ReachTree", "ReachTree"],
            treeArguments=[["Child"], ["Child"], ["Mom"], ["Child"]],
            constraintPairs=[
                ["SearchTree(child)", 1],
                [1, "ReachTree(Mom)", "until"],
                ["search-child", "Reach(Mom)", "SameRobot"],
                ["FollowTree", "Bring", "different_robot"],
            ],
        )
        assert box.call("attachMultiSubTrees", call).ok
        assert tree_of(box).links == (
            Link("search-child", "follow-child"),
            Link("follow-child", "reach-mom", "until"),
            Link("search-child", "reach-mom", "same_robot"),
            Link("follow-child", "bring", "different_robot"),
        )

    @pytest.mark.parametrize("none", [{}, [], None])
    def test_none_is_written_in_three_ways(self, box: ToolBox, none: Any) -> None:
        assert box.call("attachMultiSubTrees", attach(constraintPairs=none)).ok
        assert tree_of(box).links == ()

    @pytest.mark.parametrize("key", ["constraintPairs", "contraintsPairs", "constraintsPairs"])
    def test_the_key_has_three_spellings_of_which_one_is_given(self, box: ToolBox, key: str) -> None:
        pairs = [["Search(Child)", "Bring"]]
        both = attach() | {key: pairs, "constraintPairs" if key != "constraintPairs" else "contraintsPairs": []}
        assert rule(refused(box, "attachMultiSubTrees", **both)) == "malformed_arguments"
        assert box.call("attachMultiSubTrees", attach() | {key: pairs}).ok
        assert tree_of(box).links == (Link("search-child", "bring"),)

    @pytest.mark.parametrize(
        ("pairs", "said"),
        [
            ({"Find": "Bring"}, "an object where a list of pairs"),
            ("Find", "a text where a list of pairs"),
            (False, "true or false where a list of pairs"),
            (0, "a number where a list of pairs"),
            (["Find", "Bring"], "a text where a pair"),
            ([["Find"]], "has 1 entries"),
            ([["Find", "Bring", "Until", 1]], "has 4 entries"),
            ([["Find", None]], "null where a node"),
            ([["Find", True]], "true or false where a node"),
            ([["Find", 1.5]], "a number where a node"),
            ([["Find", "Bring", "Before"]], "no kind of link 'Before'"),
            ([["Find", "Bring", 3]], "a number where the kind"),
        ],
    )
    def test_pairs_of_another_form_are_refused(self, box: ToolBox, pairs: Any, said: str) -> None:
        answer = refused(box, "attachMultiSubTrees", **attach(constraintPairs=pairs))
        assert rule(answer) == "malformed_arguments"
        assert said in answer.reasons[0].message

    @pytest.mark.parametrize(
        "end", [1, -1, "0", "Serch(Child)", "SearchTree(Mom)", "the Bring", "SearchTree(", "", 10**30]
    )
    def test_ends_of_pairs_are_never_guessed(self, box: ToolBox, end: Any) -> None:
        """An index as a text is a name, and nothing is called "0"."""
        assert rule(refused(box, "attachMultiSubTrees", **attach(constraintPairs=[[0, end]]))) == "unknown_node"

    def test_a_link_is_set_and_dropped(self, box: ToolBox) -> None:
        assert box.call("setLink", {"first": "Find", "second": "bring"}).data["link"] == ["find", "bring", "Precedence"]
        assert box.call("setLink", {"first": "Find", "second": "bring", "kind": "SameRobot"}).ok
        assert rule(refused(box, "dropLink", first="bring", second="Find")) == "unknown_link"
        dropped = box.call("dropLink", {"first": "Find", "second": "bring", "kind": "Precedence"})
        assert dropped.data["links_dropped"] == [["find", "bring", "Precedence"]]
        assert tree_of(box).links == (Link("find", "bring", "same_robot"),)

    def test_times_are_set_and_taken_away(self, box: ToolBox) -> None:
        answer = box.call("setTimes", {"subtask": "Find", "release_s": 5, "deadline_s": 60.5})
        assert (answer.data["node"], answer.data["release_s"], answer.data["deadline_s"]) == ("find", 5, 60.5)
        assert (tree_of(box).by_id["find"].release_s, tree_of(box).by_id["find"].deadline_s) == (5, 60.5)
        box.call("setTimes", {"subtask": "find", "deadline_s": 50})
        assert (tree_of(box).by_id["find"].release_s, tree_of(box).by_id["find"].deadline_s) == (0, 50)
        box.call("setTimes", {"subtask": "find"})
        assert tree_of(box).by_id["find"].deadline_s is None

    @pytest.mark.parametrize(
        ("times", "why"),
        [
            ({"release_s": 9, "deadline_s": 8}, "times_conflict"),
            ({"deadline_s": -1}, "malformed_arguments"),
            ({"deadline_s": "60"}, "malformed_arguments"),
            ({"deadline_s": True}, "malformed_arguments"),
            ({"release_s": 1e999}, "malformed_arguments"),
        ],
    )
    def test_times_that_make_no_sense_are_refused(self, box: ToolBox, times: dict[str, Any], why: str) -> None:
        assert rule(refused(box, "setTimes", subtask="Find", **times)) == why
        assert rule(refused(box, "setTimes", subtask="nobody", deadline_s=1)) == "unknown_node"

    @pytest.mark.parametrize(
        ("kind", "back"), [("Precedence", False), ("Until", False), ("SameRobot", True), ("DifferentRobot", True)]
    )
    def test_a_link_stands_once(self, box: ToolBox, kind: str, back: bool) -> None:
        """The two mutual kinds are the same link in either direction."""
        box.call("setLink", {"first": "Find", "second": "Bring", "kind": kind})
        ends = {"first": "Bring", "second": "Find"} if back else {"second": "bring", "first": "find"}
        assert rule(refused(box, "setLink", **ends, kind=kind)) == "duplicate"

    def test_a_link_stands_once_within_a_call(self, box: ToolBox) -> None:
        pairs = [[0, "Bring"], ["search-child", "bring"]]
        assert rule(refused(box, "attachMultiSubTrees", **attach(constraintPairs=pairs))) == "duplicate"

    def test_same_and_different_contradict(self, box: ToolBox) -> None:
        box.call("setLink", {"first": "Find", "second": "Bring", "kind": "SameRobot"})
        for first, second in [("Find", "Bring"), ("Bring", "Find")]:
            assert rule(refused(box, "setLink", first=first, second=second, kind="DifferentRobot")) == "link_conflict"

    @pytest.mark.parametrize(("first", "second"), [("find", "find"), (ROOT, "find"), ("find", ROOT)])
    def test_a_node_is_not_linked_with_what_contains_it(self, box: ToolBox, first: str, second: str) -> None:
        assert rule(refused(box, "setLink", first=first, second=second)) == "contained"

    def test_a_cycle_is_refused_naming_its_nodes(self, box: ToolBox) -> None:
        """Bring would wait for the search below Find, and Find, with all below it, waits for Bring."""
        box.call("setLink", {"first": "Bring", "second": "Find"})
        answer = refused(box, "attachMultiSubTrees", **attach(constraintPairs=[["Search(Child)", "Bring"]]))
        assert rule(answer) == "cycle"
        for node in ("bring", "find", "search-child"):
            assert node in answer.reasons[0].message

    def test_of_many_pairs_the_one_that_closes_the_cycle_is_named(self, box: ToolBox) -> None:
        names = [f"t{number}" for number in range(6)]
        pairs = [[number, number + 1] for number in range(5)] + [[4, 2], [0, 5]]
        call = {
            "parentString": "Find",
            "isPrimitiveList": [False] * 6,
            "taskNameList": names,
            "LogicalConstraint": "AND",
        }
        answer = refused(box, "addMultiSubtasks", **call, constraintPairs=pairs)
        assert rule(answer) == "cycle"
        assert "from 't4' to 't2' closes a cycle" in answer.reasons[0].message
        assert "t0" not in answer.reasons[0].message

    def test_a_long_cycle_is_named_in_short(self, box: ToolBox) -> None:
        """60 tasks in a row, and the first after the last: 61 names back to the first, of which 20 are shown."""
        call = {"parentString": "Find", "isPrimitiveList": [False] * 60, "LogicalConstraint": "AND"}
        names = [f"t{number}" for number in range(60)]
        pairs = [[number, (number + 1) % 60] for number in range(60)]
        answer = refused(box, "addMultiSubtasks", **call, taskNameList=names, constraintPairs=pairs)
        assert "(41 more)" in answer.reasons[0].message
        assert answer.reasons[0].message.count(" > ") == 20

    def test_until_and_waiting_for_the_end_is_a_cycle(self, box: ToolBox) -> None:
        """Find would last until Bring ends, which cannot start before Find has ended."""
        box.call("setLink", {"first": "Find", "second": "Bring"})
        assert rule(refused(box, "setLink", first="Find", second="Bring", kind="Until")) == "cycle"

    def test_precedence_between_children_of_a_xor_is_let_in(self, box: ToolBox) -> None:
        """Refused is what could never be; this merely never binds, and the findings say so."""
        lists = {"parentString": "Find", "isPrimitiveList": [False, False], "taskNameList": ["A", "B"]}
        assert box.call("addMultiSubtasks", lists | {"LogicalConstraint": "XOR", "constraintPairs": [[0, 1]]}).ok
        rules = [finding["rule"] for finding in box.call("checkTree").data["findings"]]
        assert "link_never_binds" in rules


class TestRemoval:
    def test_a_subtree_goes_with_its_links(self, box: ToolBox) -> None:
        box.call("attachMultiSubTrees", attach(constraintPairs=[["Search(Child)", "Bring"]]))
        answer = box.call("removeSubtask", {"subtask": "Find"})
        assert answer.data["removed"] == ["find", "search-child"]
        assert answer.data["links_dropped"] == [["search-child", "bring", "Precedence"]]
        assert [node.id for node in tree_of(box).nodes] == [ROOT, "bring"]
        assert tree_of(box).links == ()
        assert tree_of(box).root.gate == "and"

    def test_a_xor_that_loses_all_but_one_child_reads_and(self, box: ToolBox) -> None:
        for name in ("A", "B"):
            box.call("CreateAndAddSubtask", subtask(name=name, gate="XOR"))
        assert tree_of(box).by_id["find"].gate == "xor"
        box.call("removeSubtask", {"subtask": "A"})
        assert tree_of(box).by_id["find"].gate == "and"
        assert box.call("CreateAndAddSubtask", subtask(name="C", gate="XOR")).ok
        assert tree_of(box).by_id["find"].gate == "xor"

    def test_the_root_stays(self, box: ToolBox) -> None:
        assert rule(refused(box, "removeSubtask", subtask=REUNITE)) == "root_stays"

    def test_what_is_not_there_cannot_be_removed(self, box: ToolBox) -> None:
        assert rule(refused(box, "removeSubtask", subtask="Fnd")) == "unknown_node"


class TestTelling:
    def test_print_tree_gives_the_outline(self, box: ToolBox) -> None:
        box.call(
            "attachMultiSubTrees", attach(treeArguments=[["Child", ["tele_robot"]]], constraintPairs=[[0, "Bring"]])
        )
        assert box.call("printTree").data["tree"].splitlines() == [
            f"- {REUNITE} ({ROOT}) [AND]",
            "  - Find (find) [AND]",
            "    - Search(Child) (search-child) only tele_robot",
            "  - Bring (bring) [open]",
            "Precedence: search-child -> bring",
        ]

    def test_plot_tree_draws_with_what_was_handed_in(self, brief: MissionBrief) -> None:
        box = ToolBox(TreeBuilder(brief), draw=lambda tree: f"<svg>{tree.objective}</svg>")
        box.call("HierarchicalTree_init", {"objective": "Find mom"})
        answer = box.call("plotTree")
        assert answer.picture == "<svg>Find mom</svg>"
        assert "<svg>" not in answer.text

    def test_plot_tree_without_a_drawer_says_where_to_look(self, box: ToolBox) -> None:
        answer = box.call("plotTree")
        assert answer.picture == ""
        assert "printTree" in answer.data["picture"]

    def test_check_tree_lists_open_leaves(self, box: ToolBox) -> None:
        answer = box.call("checkTree")
        assert answer.data["complete"] is False
        assert [(found["rule"], found["node"]) for found in answer.data["findings"]] == [
            ("open_leaf", "find"),
            ("open_leaf", "bring"),
        ]

    def test_list_routines_says_who_can_and_why_others_cannot(self, box: ToolBox) -> None:
        rows = {row["name"]: row for row in box.call("listRoutines").data["routines"]}
        assert list(rows) == [routine.wire_name for routine in box.builder.brief.routines.routines]
        assert rows["SearchTree"]["can_be_done_by"] == ["tele_robot", "transportation_robot"]
        # The Mobile Scooter and the Social Robot have no Search in Table I.
        assert len(rows["SearchTree"]["not_by"]) == 2

    def test_routines_that_nobody_can_do_are_not_on_offer(self, brief: MissionBrief) -> None:
        fleet = Fleet((RobotType(id="walker", count=1, capabilities={"reach": 1.0}),))
        box = ToolBox(TreeBuilder(MissionBrief(text="x", fleet=fleet, routines=brief.routines)))
        assert box.call("HierarchicalTree_init", {"objective": "x"}).data["routines"] == ["ReachTree(agent)"]


class TestDeclining:
    def test_the_missing_capability_is_kept(self, box: ToolBox) -> None:
        assert box.call("declareImpossible", {"missing": "recommend", "reason": "Nobody knows restaurants."}).ok
        (reason,) = box.builder.state.impossible
        assert (reason.rule, reason.needed) == ("declared_impossible", "recommend")

    def test_a_capability_that_is_there_earns_a_notice(self, box: ToolBox) -> None:
        answer = box.call("declareImpossible", {"missing": "carry", "reason": "Too heavy."})
        assert [notice.rule for notice in answer.notices] == ["capability_present"]
        assert "Transportation Robot" in answer.notices[0].message

    def test_it_needs_no_tree_and_is_the_last_word(self, brief: MissionBrief) -> None:
        box = ToolBox(TreeBuilder(brief))
        assert box.call("declareImpossible", {"missing": "cook", "reason": "No kitchen."}).ok
        assert rule(refused(box, "declareImpossible", missing="fly", reason="No wings.")) == "ended"
        assert rule(refused(box, "HierarchicalTree_init", objective="Cook")) == "ended"
        assert box.call("listRoutines").ok

    @pytest.mark.parametrize("given", [{"missing": "", "reason": "x"}, {"missing": "x", "reason": " "}])
    def test_it_needs_words(self, box: ToolBox, given: dict[str, str]) -> None:
        assert rule(refused(box, "declareImpossible", **given)) == "malformed_arguments"


class TestMistakenKinds:
    """An entity that was introduced as something else than it is can be put right until somebody counts on it."""

    def test_another_kind_replaces_the_first(self, scenic_box: ToolBox) -> None:
        assert scenic_box.call("introduceEntity", {"name": "Rex", "kind": "person"}).ok
        answer = scenic_box.call("introduceEntity", {"name": "Rex", "kind": "dog"})
        assert answer.ok
        assert [(entity.label, entity.kind) for entity in tree_of(scenic_box).entities] == [("Rex", "dog")]

    def test_the_same_kind_again_says_nothing_new(self, scenic_box: ToolBox) -> None:
        assert scenic_box.call("introduceEntity", {"name": "Rex", "kind": "dog"}).ok
        answer = scenic_box.call("introduceEntity", {"name": "rex", "kind": "dog"})
        assert [reason.rule for reason in answer.reasons] == ["duplicate"]

    def test_what_a_routine_uses_stays_what_it_was_taken_for(self, scenic_box: ToolBox) -> None:
        assert scenic_box.call("introduceEntity", {"name": "Rex", "kind": "person"}).ok
        call = {"parentString": "find", "treeNames": ["SearchTree"], "treeArguments": [["Rex"]]}
        assert scenic_box.call("attachMultiSubTrees", {**call, "LogicalConstraint": "AND"}).ok
        answer = scenic_box.call("introduceEntity", {"name": "Rex", "kind": "dog"})
        assert "search-rex" in answer.reasons[0].message
        assert tree_of(scenic_box).entities[0].kind == "person"

    def test_a_thing_of_the_scene_is_what_the_scene_says(self, scenic_box: ToolBox) -> None:
        answer = scenic_box.call("introduceEntity", {"name": "child", "kind": "dog"})
        assert [reason.rule for reason in answer.reasons] == ["duplicate"]


def test_nothing_is_brought_to_itself(scenic_box: ToolBox) -> None:
    call = {"parentString": "bring", "treeNames": ["TransportTree"], "treeArguments": [["child", "Tim"]]}
    answer = scenic_box.call("attachMultiSubTrees", {**call, "LogicalConstraint": "AND"})
    assert [reason.rule for reason in answer.reasons] == ["same_entity_twice"]
    assert "Tim as agent and as location" in answer.reasons[0].message
